#include "elementTests/testTypes.hpp"
#include "base/csv.hpp"
#include "base/readText.hpp"
#include "base/words.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <numbers>

namespace sph
{

const std::vector<TestType>& testTypes()
{
    constexpr Tensor<3> compression{0, 0, 0, 0, 0, 0, 0, 0, -1}, extension{0, 0, 0, 0, 0, 0, 0, 0, 1};
    constexpr SymmTensor<3> q{0.5, 0, 0, 0.5, 0, -1};
    constexpr auto strain = "strain [-]";
    static const std::vector<TestType> all{
        {"oedometer",
         "compression along z, no lateral strain",
         compression,
         {},
         &entry::strain,
         strain,
         &entry::verticalStress,
         {0, 0, 0, 0, 0, -1}},
        {"triaxialCompression",
         "compression along z, drained: lateral stresses held; undrained: the volume",
         compression,
         {true, false, false, true},
         &entry::strain,
         strain,
         &entry::deviatorStress,
         q,
         Tensor<3>{0.5, 0, 0, 0, 0.5, 0, 0, 0, -1}},
        {"triaxialExtension",
         "extension along z, drained: lateral stresses held; undrained: the volume",
         extension,
         {true, false, false, true},
         &entry::strain,
         strain,
         &entry::deviatorStress,
         q,
         Tensor<3>{-0.5, 0, 0, 0, -0.5, 0, 0, 0, 1}},
        {"biaxial",
         "plane strain: compression along z, no strain along y, drained: stress along x held; undrained: the volume",
         compression,
         {true},
         &entry::strain,
         strain,
         &entry::deviatorStress,
         {1, 0, 0, 0, 0, -1},
         Tensor<3>{1, 0, 0, 0, 0, 0, 0, 0, -1}},
        {"isotropic",
         "compression of the volume",
         {-1. / 3, 0, 0, 0, -1. / 3, 0, 0, 0, -1. / 3},
         {},
         &entry::strain,
         strain,
         &entry::meanPressure,
         {-1. / 3, 0, 0, -1. / 3, 0, -1. / 3}},
        {"simpleShear",
         "at constant vertical stress",
         {0, 0, 1, 0, 0, 0, 0, 0, 0},
         {false, false, false, false, false, true},
         &entry::gamma,
         "gamma [-]"},
        {"constantVolumeShear", "simple shear at constant volume", {0, 0, 1, 0, 0, 0, 0, 0, 0}, {}, &entry::gamma, "gamma [-]"},
        {"rotation", "of the whole, without strain", {}, {}, &entry::angle, "angle [degrees]"},
        {"strainPath", "strains of a table", {}, {}, nullptr, "length of the path [-]"},
    };
    return all;
}

std::vector<std::vector<double>> readTable(const Case& c, const std::string& file, const std::vector<std::string>& columns, bool optional,
                                           std::vector<std::string>* found)
{
    auto& diagnostics = c.diagnostics();
    std::vector<std::vector<double>> rows;
    std::vector<std::string> names;
    std::string reason;
    const auto text = readText(c.folder() / file, reason);
    if (!text)
    {
        diagnostics.error({file, 0}, reason);
        return rows;
    }
    CsvLines lines(*text);
    while (const auto line = lines.next())
    {
        const auto& cells = *line;
        const Location here{file, lines.number()};
        if (names.empty())
        {
            names = cells;
            if (found) *found = names;
            for (const auto& name : names)
                if (std::ranges::find(columns, name) == columns.end())
                    diagnostics.error(here, fmt::format("column \"{}\" is unknown. {}", name, suggestion(name, "columns", columns)));
            for (const auto& column : columns)
                if (!optional && std::ranges::find(names, column) == names.end())
                    diagnostics.error(here, fmt::format("column \"{}\" is missing. Needed: {}", column, list(columns)));
            continue;
        }
        if (cells.size() != names.size())
        {
            diagnostics.error(here, fmt::format("{} cells under {} names", cells.size(), names.size()));
            continue;
        }
        std::vector<double> row(columns.size(), 0);
        for (std::size_t k = 0; k < cells.size(); ++k)
        {
            const auto value = finiteNumber(cells[k]);
            const auto at = std::ranges::find(columns, names[k]);
            if (!value) diagnostics.error(here, fmt::format("\"{}\" under {} is no number", beginning(cells[k]), names[k]));
            else if (at != columns.end()) row[std::size_t(at - columns.begin())] = *value;
        }
        rows.push_back(row);
    }
    if (rows.empty()) diagnostics.error({file, 0}, "has no rows of numbers");
    return rows;
}

void addLegs(const Dictionary& d, const TestType& type, const ListOf<double>& driver, const std::vector<double>& targets, int cycles,
             ElementTest& test, const std::string& stage)
{
    const bool byStress = &driver == type.orBy;
    auto unit = type.unit;
    if (type.drivenBy == &entry::angle)
    {
        const auto n = std::numbers::pi / 180 * entry::axis(d);
        unit = {0, -n.z, n.y, n.z, 0, -n.x, -n.y, n.x, 0};
    }
    const bool drained = !type.undrained || entry::drainage(d) == "drained";
    if (!drained) unit = *type.undrained;
    std::vector<StressControl> held;
    for (std::size_t k = 0; drained && k < type.held.size(); ++k)
        if (type.held[k]) held.push_back(heldComponent(symmComponents[k]));
    if (byStress) test.pathAxis = fmt::format("{} [Pa]", driver.keyword());
    double before = 0;
    for (int cycle = 0; cycle < cycles; ++cycle)
        for (const double target : targets)
        {
            ElementLeg leg{.path = target, .controls = held, .drains = drained, .stage = stage};
            if (byStress) leg.controls.push_back({symm(unit), type.measure, target});
            else leg.deformation = (target - before) * unit;
            test.legs.push_back(leg);
            before = target;
        }
}

namespace
{

SymmTensor<3> readStart(const Dictionary& d)
{
    if (!entry::stress.given(d))
    {
        const double p = entry::pressure.needed(d), K = entry::K(d);
        return {-K * p, 0, 0, -K * p, 0, -p};
    }
    if (entry::pressure.given(d) || entry::K.given(d))
        entry::stress.error(d, "the start is given twice: keep `stress`, or `pressure` and `K`");
    const auto s = entry::stress(d, {});
    if (s.size() == 6) return {s[0], s[1], s[2], s[3], s[4], s[5]};
    entry::stress.error(d, fmt::format("a stress has six components, xx xy xz yy yz zz, not {}", s.size()));
    return {-1, 0, 0, -1, 0, -1};
}

}

void readState(const Dictionary& d, const SoilLaw& any, ElementTest& test)
{
    test.stress = readStart(d);
    const auto& at = entry::stress.given(d) ? static_cast<const Parameter&>(entry::stress) : entry::pressure;
    std::visit(
        [&]<class Law>(const Law& law)
        {
            StateOf<Law> state;
            state.stress = test.stress;
            if constexpr (LawOfState<Law>)
            {
                state.variables = law.readVariables(d)(test.stress);
                test.variables = numbersOf(state.variables);
                if (const auto why = law.objection(state); Law::startGiven(d) && !why.empty() && -trace(state.stress) > 0)
                {
                    Law::startEntry().error(d, why);
                    return;
                }
            }
            if (law.admits(state)) return;
            const auto principal = principalValues(test.stress);
            at.error(
                d,
                fmt::format(
                    "the start has the principal stresses {:.6g}, {:.6g} and {:.6g} Pa, tension positive, trace {:.6g}: the law needs {}",
                    principal[0], principal[1], principal[2], trace(test.stress),
                    Law::tensionless ? "a negative trace and no tension" : "a stress within the soil's strength"));
        },
        any);
}

EntryList startEntries() { return EntryList{entry::pressure, entry::K, entry::stress} + variableEntries(); }

}
