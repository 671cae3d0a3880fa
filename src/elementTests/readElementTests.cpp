#include "elementTests/readElementTests.hpp"
#include "base/csv.hpp"
#include "base/readText.hpp"
#include "base/words.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>
#include <numbers>

namespace sph
{

namespace entry
{
const SubDictionary tests{"tests", notGiven, "element tests by names of the case's own"};
const FreeName test{"<test>", "dictionary", "a test, whose name is that of its file"};
const Scalar pressure{"pressure", units::pressure, byScene("needed without stress"), positive, "at the start, vertical (along z)"},
    K{"K", units::none, 1, nonNegative, "horizontal over vertical stress at the start"};
const ListOf<double> stress{"stress", units::pressure, byScene("of pressure and K"), "at the start, xx xy xz yy yz zz, tension positive"};
const Count points{"points", 100, Range{1, 1e6}, "rows of each piece of the path"};
const ListOf<double> strain{"strain", byScene("needed without a stress"),
                            "what is reached one after another, of the sign that the test is named by"},
    verticalStress{"verticalStress", units::pressure, byScene("strain"), "compression positive, what is reached one after another"},
    meanPressure{"meanPressure", units::pressure, byScene("strain"), "what is reached one after another"},
    deviatorStress{"deviatorStress", units::pressure, byScene("strain"),
                   "axial less lateral stress, compression positive, what is reached one after another"};
const Count cycles{"cycles", 1, Range{1, 1e6}, "how often the list is gone through"};
const Choice drainage{"drainage",
                      {{"drained", "lateral stresses are held"},
                       {"undrained", "the volume is held, and the total lateral stress: porePressure is what the effective one gives up"}},
                      "drained",
                      "of the water in the pores"};
const SubDictionary stages{"stages", byScene("of type"), "pieces one after another, in place of type: consolidate, then shear"};
const FreeName stage{"<stage>", "dictionary", "a piece by a name of the case's own"};
const ListOf<double> gamma{"gamma", required, "dv_x/dz t: what is reached one after another"},
    angle{"angle", required, "[degrees], what is reached one after another"};
const Direction axis{"axis", Vector<3>{0, 1, 0}, "that the soil turns about"};
const FileName path{"file", "", required,
                    "table with columns of xx xy xz yy yz zz, strains from the start on, extension positive; what has no column is 0"};
const Switch plots{"plots", true, "draw the tests, by gnuplot"};

const SubDictionary calibration{"calibration", notGiven,
                                "a drained triaxial compression, from which -calibrate finds c1 ... c4 of law wuBauer"};
const Scalar lateral{"pressure", units::pressure, required, positive, "lateral"},
    initialStiffness{"initialStiffness", units::pressure, byScene("needed without file"), positive,
                     "d(deviator)/d(axial strain) at the start"},
    initialVolumeSlope{"initialVolumeSlope", units::none, byScene("needed without file"), positiveBelow(2),
                       "d(volume strain)/d(axial strain) at the start, compression positive"},
    peak{"peak", units::pressure, byScene("needed without file"), positive, "largest deviator"},
    peakVolumeSlope{"peakVolumeSlope", units::none, byScene("needed without file"), Range{-10, 1, true, false},
                    "d(volume strain)/d(axial strain) at the peak: negative where the soil dilates"};
const FileName measured{
    "file", "", byScene("the four figures"),
    "table with columns axialStrain, q [Pa], volumeStrain, compression positive, up to the peak; all of its points count"};
}

namespace
{

/// Compression or shear for a path of 1, and which stresses are held.
struct TestType
{
    const char *name, *meaning;
    Tensor<3> unit;
    std::array<bool, 6> held; ///< xx xy xz yy yz zz
    const ListOf<double>* drivenBy;
    const char* axis = "strain [-]"; ///< of what drives it
    /// Stress that may drive it in place of the strain, and measure:sigma of that.
    const ListOf<double>* orBy = nullptr;
    SymmTensor<3> measure = {};
    std::optional<Tensor<3>> undrained = {}; ///< for a path of 1 at constant volume
};

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

Cases typeCases()
{
    Cases cases;
    for (const auto& type : testTypes())
    {
        EntryList beside;
        if (type.drivenBy) beside.push_back(*type.drivenBy);
        else beside.push_back(entry::path);
        if (type.drivenBy == &entry::angle) beside.push_back(entry::axis);
        if (type.orBy) beside.push_back(*type.orBy);
        if (type.undrained) beside.push_back(entry::drainage);
        if (type.drivenBy) beside.push_back(entry::cycles);
        cases.push_back({{type.name, type.meaning}, beside});
    }
    return cases;
}

}

namespace entry
{
const Choice type{"type", wordsOf(typeCases()), byScene("needed without stages"), "what is done to the soil"};
}

namespace
{

/// Rows of numbers with the columns that are asked for by name, in that order; `#` begins a comment. `optional` columns may be missing: 0.
std::vector<std::vector<double>> readTable(const Case& c, const std::string& file, const std::vector<std::string>& columns, bool optional)
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

void readStrainPath(const Case& c, const Dictionary& d, ElementTest& test, const std::string& stage)
{
    const auto file = entry::path.needed(d);
    if (!entry::path.given(d)) return;
    SymmTensor<3> before;
    double path = 0;
    for (const auto& row : readTable(c, file, {"xx", "xy", "xz", "yy", "yz", "zz"}, true))
    {
        SymmTensor<3> strain;
        for (std::size_t k = 0; k < row.size(); ++k) strain.*symmComponents[k] = row[k];
        const auto change = strain - before;
        path += norm(change);
        test.legs.push_back({.deformation = full(change), .path = path, .stage = stage});
        before = strain;
    }
}

void readLegs(const Dictionary& d, const TestType& type, ElementTest& test, const std::string& stage)
{
    const bool byStress = type.orBy && type.orBy->given(d);
    if (byStress && type.drivenBy->given(d))
        type.orBy->error(d, fmt::format("the test is driven twice: keep {} or {}", type.drivenBy->keyword(), type.orBy->keyword()));
    const auto& driver = byStress ? *type.orBy : *type.drivenBy;
    const auto targets = driver.needed(d);
    if (targets.empty() && driver.given(d)) driver.error(d, fmt::format("\"{}\" is empty: give at least one number", driver.keyword()));
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
    const int cycles = entry::cycles(d);
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

/// What is done in a test without stages, or in one of its stages.
void readPiece(const Case& c, const Dictionary& d, ElementTest& test, const std::string& stage)
{
    const auto word = entry::type.known(d);
    if (!word) return;
    const auto& type = testTypes()[std::size_t(entry::type.indexOf(*word))];
    test.type += (test.type.empty() ? "" : ", ") + *word;
    test.pathAxis = type.axis;
    if (type.drivenBy) readLegs(d, type, test, stage);
    else readStrainPath(c, d, test, stage);
}

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

/// The state at the start, where the law does not hold for it an error at the entry that is wrong.
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

ElementTest readTest(const Case& c, const Dictionary& d, const SoilLaw& law)
{
    ElementTest test;
    test.name = d.keyword();
    test.where = d.location();
    test.points = entry::points(d);
    readState(d, law, test);
    const bool staged = entry::stages.given(d);
    if (staged && entry::type.given(d)) entry::type.error(d, "what is done is said twice: keep `type`, or `stages` with a type each");
    if (!staged) entry::type.needed(d);
    if (entry::type.given(d)) readPiece(c, d, test, "");
    if (!staged) return test;
    const auto stages = entry::stages(d);
    for (const auto& name : stages.keys())
        if (stages.isDictionary(name))
        {
            entry::type.needed(stages.subDict(name));
            readPiece(c, stages.subDict(name), test, name);
        }
        else stages.error(name, fmt::format("\"{}\" is to be a dictionary: {} {{ type isotropic; .. }}", name, name));
    if (stages.keys().empty())
        entry::stages.error(d, "there are no stages: give at least one, as stages { shear { type triaxialCompression; .. } }");
    test.pathAxis = "path of each stage";
    return test;
}

}

ElementTestPlan readElementTests(const Case& c, const SoilLaw& law)
{
    const auto d = c.dictionary(elementTestDictionary);
    ElementTestPlan plan;
    plan.plots = entry::plots(d);
    const auto tests = entry::tests(d);
    for (const auto& name : tests.keys())
    {
        if (!tests.isDictionary(name))
            tests.error(name, fmt::format("\"{}\" is to be a dictionary: {} {{ type oedometer; .. }}", name, name));
        else if (!std::ranges::all_of(name, [](unsigned char k) { return std::isalnum(k) || k == '_' || k == '-' || k == '.'; }))
            tests.error(name, "the name of a test is that of its file: letters, digits, _ - and . alone");
        else plan.tests.push_back(readTest(c, tests.subDict(name), law));
    }
    if (tests.keys().empty()) d.error("tests", "there are no tests: give at least one, as tests { oedometer { type oedometer; .. } }");
    d.ignore("calibration");
    d.reportUnused();
    return plan;
}

Measurement readMeasurement(const Case& c)
{
    const auto dict = c.dictionary(elementTestDictionary);
    const auto d = entry::calibration.needed(dict);
    Measurement m;
    m.where = d.location();
    auto& f = m.figures;
    f.pressure = entry::lateral(d);
    if (entry::measured.given(d))
    {
        const auto file = entry::measured.needed(d);
        for (const auto* figure : {&entry::initialStiffness, &entry::initialVolumeSlope, &entry::peak, &entry::peakVolumeSlope})
            if (figure->given(d)) figure->error(d, "is taken from the table: keep the file or the four figures");
        for (const auto& row : readTable(c, file, {"axialStrain", "q", "volumeStrain"}, false))
            m.points.push_back({row[0], row[1], row[2]});
        m.where = entry::measured.where(d);
    }
    else
    {
        f.initialStiffness = entry::initialStiffness.needed(d);
        f.initialVolumeSlope = entry::initialVolumeSlope.needed(d);
        f.peak = entry::peak.needed(d);
        f.peakVolumeSlope = entry::peakVolumeSlope.needed(d);
    }
    for (const char* other : {"tests", "plots"}) dict.ignore(other);
    dict.reportUnused();
    return m;
}

EntryList elementTestEntries()
{
    const EntryList piece{{entry::type, typeCases()}};
    return {{entry::tests,
             {{entry::test, piece + EntryList{entry::pressure, entry::K, entry::stress} + variableEntries() +
                                EntryList{{entry::stages, {{entry::stage, piece}}}, entry::points}}}},
            entry::plots,
            {entry::calibration,
             {entry::lateral, entry::initialStiffness, entry::initialVolumeSlope, entry::peak, entry::peakVolumeSlope, entry::measured}}};
}

}
