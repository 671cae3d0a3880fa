#include "elementTests/readElementTests.hpp"
#include "base/csv.hpp"
#include "base/readText.hpp"
#include "base/words.hpp"
#include "dictionary/DictionaryNode.hpp"
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

const SubDictionary calibration{
    "calibration", notGiven,
    "what -calibrate finds constants from: a drained triaxial compression, for c1 ... c4 of law wuBauer, or tests, for those of any law"};
const Scalar lateral{"pressure", units::pressure, byScene("needed without tests"), positive, "lateral"},
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
const SubDictionary constants{"constants", byScene("needed with tests"),
                              "what is sought, by entries of the law's coefficients: M (0.5 1.5)"};
const FreeName constant{"<constant>", "list of numbers",
                        "least and largest value; that of constant/soilProperties is where the search begins"};
const SubDictionary measuredTests{"tests", byScene("of one triaxial test"), "measured tests, which are fitted together"};
const FreeName measuredTest{"<test>", "dictionary", "a test by a name of the case's own"};
const FileName curves{
    "file", "", required,
    "table with a column of what the test is driven by (strain, gamma, verticalStress, meanPressure, deviatorStress), and columns that were "
    "measured: verticalStress, lateralStress, meanPressure, deviatorStress (vertical less lateral), shearStress, porePressure [Pa], strain (vertical), "
    "volumeStrain, voidRatio; compression positive"};
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

/// Tests that may be measured: driven by a number, and not the turn of the whole.
Cases measuredCases()
{
    Cases cases;
    for (const auto& type : testTypes())
        if (type.drivenBy && type.drivenBy != &entry::angle)
            cases.push_back({{type.name, type.meaning}, type.undrained ? EntryList{entry::drainage} : EntryList{}});
    return cases;
}

}

namespace entry
{
const Choice measuredType{"type", wordsOf(measuredCases()), required, "what was done to the soil"};
const Choice type{"type", wordsOf(typeCases()), byScene("needed without stages"), "what is done to the soil"};
}

namespace
{

/// Rows of numbers with the columns that are asked for by name, in that order; `#` begins a comment. `optional` columns may be missing: 0; `found`:
/// those that are there.
std::vector<std::vector<double>> readTable(const Case& c, const std::string& file, const std::vector<std::string>& columns, bool optional,
                                           std::vector<std::string>* found = nullptr)
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

/// Legs to these strains or stresses.
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

void readLegs(const Dictionary& d, const TestType& type, ElementTest& test, const std::string& stage)
{
    const bool byStress = type.orBy && type.orBy->given(d);
    if (byStress && type.drivenBy->given(d))
        type.orBy->error(d, fmt::format("the test is driven twice: keep {} or {}", type.drivenBy->keyword(), type.orBy->keyword()));
    const auto& driver = byStress ? *type.orBy : *type.drivenBy;
    const auto targets = driver.needed(d);
    if (targets.empty() && driver.given(d)) driver.error(d, fmt::format("\"{}\" is empty: give at least one number", driver.keyword()));
    addLegs(d, type, driver, targets, entry::cycles(d), test, stage);
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

bool hasMeasuredTests(const Case& c) { return entry::measuredTests.given(entry::calibration(c.dictionary(elementTestDictionary))); }

namespace
{

/// What the columns of measured tables are of a row, compression positive.
struct Measured
{
    const char* name;
    double (*of)(const ElementRow&);
};
constexpr Measured measurable[]{
    {"strain", [](const ElementRow& row) { return -row.strain.zz; }},
    {"verticalStress", [](const ElementRow& row) { return -row.stress.zz; }},
    {"lateralStress", [](const ElementRow& row) { return -row.stress.xx; }},
    {"meanPressure", [](const ElementRow& row) { return -trace(row.stress) / 3; }},
    {"deviatorStress", [](const ElementRow& row) { return row.stress.xx - row.stress.zz; }},
    {"shearStress", [](const ElementRow& row) { return row.stress.xz; }},
    {"porePressure", [](const ElementRow& row) { return row.porePressure; }},
    {"volumeStrain", [](const ElementRow& row) { return -trace(row.strain); }},
    {"voidRatio", [](const ElementRow& row) { return row.variables.at(0); }},
};

MeasuredTest readMeasuredTest(const Case& c, const Dictionary& d, const SoilLaw& law)
{
    MeasuredTest measured;
    auto& test = measured.test;
    test.name = d.keyword();
    test.where = d.location();
    test.points = 1;
    readState(d, law, test);
    const auto word = entry::measuredType.known(d);
    const auto file = entry::curves(d);
    if (!word) entry::measuredType(d); // which says what is wrong
    if (!word || !entry::curves.given(d)) return measured;
    const auto& type = *std::ranges::find(testTypes(), *word, [](const TestType& each) { return std::string(each.name); });
    test.type = *word;
    const bool hasVoidRatio = std::visit([]<class Law>(const Law&) { return LawOfVoidRatio<Law>; }, law);
    std::vector<std::string> columns;
    if (type.drivenBy == &entry::gamma) columns.emplace_back("gamma");
    for (const auto& each : measurable) columns.emplace_back(each.name);
    std::vector<std::string> names;
    const auto rows = readTable(c, file, columns, true, &names);
    const auto has = [&](const std::string& name) { return std::ranges::find(names, name) != names.end(); };
    const auto& driver = type.drivenBy && has(type.drivenBy->keyword()) ? *type.drivenBy : type.orBy ? *type.orBy : *type.drivenBy;
    if (!has(driver.keyword()))
    {
        c.diagnostics().error({file, 1}, fmt::format("no column drives the test: {}{} is needed of type {}", type.drivenBy->keyword(),
                                                     type.orBy ? " or " + type.orBy->keyword() : "", type.name));
        return measured;
    }
    const auto column = [&](const std::string& name) { return std::size_t(std::ranges::find(columns, name) - columns.begin()); };
    // A row at the start, where nothing has happened yet, holds nothing to compare.
    const auto place = column(driver.keyword());
    std::vector<std::vector<double>> used;
    for (const auto& row : rows)
        if (row[place] != (used.empty() ? 0 : used.back()[place])) used.push_back(row);
    std::vector<double> targets;
    for (const auto& row : used) targets.push_back(row[place]);
    addLegs(d, type, driver, targets, 1, test, "");
    for (const auto& each : measurable)
    {
        if (!has(each.name) || each.name == driver.keyword()) continue;
        if (each.name == std::string("voidRatio") && !hasVoidRatio)
        {
            c.diagnostics().error({file, 1}, "column \"voidRatio\": the law has none; volumeStrain is possible");
            continue;
        }
        MeasuredCurve curve{each.name, {}, each.of};
        for (const auto& row : used) curve.values.push_back(row[column(each.name)]);
        measured.curves.push_back(curve);
    }
    if (measured.curves.empty())
        c.diagnostics().error({file, 1},
                              fmt::format("nothing was measured: beside {} a column of {} is needed", driver.keyword(), list(columns)));
    return measured;
}

}

std::string entryAs(const std::string& path, const std::string& value)
{
    const auto dot = path.find('.');
    if (dot == std::string::npos) return fmt::format("{} {};", path, value);
    return fmt::format("{} {{ {} }}", path.substr(0, dot), entryAs(path.substr(dot + 1), value));
}

FitPlan readFit(const Case& c, const SoilLaw& law)
{
    const auto dict = c.dictionary(elementTestDictionary);
    const auto d = entry::calibration.needed(dict);
    FitPlan plan;
    plan.where = d.location();
    const auto constants = entry::constants.needed(d);
    for (const auto& name : constants.keys())
    {
        const auto bounds = constants.get<std::vector<double>>(name);
        if (bounds.size() != 2 || !(bounds[0] < bounds[1]))
            constants.error(name, fmt::format("{} needs its least and its largest value, as {} (0.1 0.5)", name, name));
        else plan.constants.push_back({name, bounds[0], bounds[1], constants.where(name)});
    }
    if (entry::constants.given(d) && constants.keys().empty())
        entry::constants.error(d, "no constant is sought: give at least one, as M (0.5 1.5)");
    const auto tests = entry::measuredTests.needed(d);
    for (const auto& name : tests.keys())
        if (tests.isDictionary(name)) plan.tests.push_back(readMeasuredTest(c, tests.subDict(name), law));
        else tests.error(name, fmt::format("\"{}\" is to be a dictionary: {} {{ type oedometer; file ..; }}", name, name));
    if (entry::measuredTests.given(d) && tests.keys().empty()) entry::measuredTests.error(d, "there are no tests: give at least one");
    for (const char* other : {"tests", "plots"}) dict.ignore(other);
    dict.reportUnused();
    return plan;
}

Soil readSoilWith(const Case& c, const std::vector<FittedConstant>& constants, const std::vector<double>& values)
{
    const auto properties = c.dictionary(soilProperties);
    const auto coeffs = properties.get<std::string>("law", "") + "Coeffs";
    std::string text;
    for (std::size_t k = 0; k < constants.size(); ++k) text += entryAs(coeffs + "." + constants[k].entry, written(values[k])) + "\n";
    const auto others = Dictionary::parse(text, soilProperties, c.sharedDiagnostics());
    for (const auto& entry : others.node().entries) properties.node().add(entry, InputMode::merge);
    return readSoil(properties, "within");
}

std::vector<double> startOf(const Case& c, const std::vector<FittedConstant>& constants)
{
    const auto properties = c.dictionary(soilProperties);
    std::vector<double> start;
    for (const auto& constant : constants)
    {
        auto d = properties.subDictOrEmpty(properties.get<std::string>("law", "") + "Coeffs");
        auto name = constant.entry;
        for (auto dot = name.find('.'); dot != std::string::npos; dot = name.find('.'))
        {
            d = d.subDictOrEmpty(name.substr(0, dot));
            name = name.substr(dot + 1);
        }
        start.push_back(0);
        if (!d.found(name))
            c.diagnostics().error(constant.where,
                                  fmt::format("the coefficients of the law in {} have no {}: where the search begins must be said there",
                                              soilProperties, constant.entry));
        else if (const double value = start.back() = d.get<double>(name); value < constant.least || value > constant.largest)
            d.error(name, fmt::format("{} {:.6g} is not between {:.6g} and {:.6g}, the bounds of the calibration: the search begins there",
                                      name, value, constant.least, constant.largest));
    }
    return start;
}

EntryList elementTestEntries()
{
    const EntryList piece{{entry::type, typeCases()}};
    return {{entry::tests,
             {{entry::test, piece + EntryList{entry::pressure, entry::K, entry::stress} + variableEntries() +
                                EntryList{{entry::stages, {{entry::stage, piece}}}, entry::points}}}},
            entry::plots,
            {entry::calibration,
             {entry::lateral,
              entry::initialStiffness,
              entry::initialVolumeSlope,
              entry::peak,
              entry::peakVolumeSlope,
              entry::measured,
              {entry::constants, {entry::constant}},
              {entry::measuredTests,
               {{entry::measuredTest,
                 EntryList{{entry::measuredType, measuredCases()}, entry::curves, entry::pressure, entry::K, entry::stress} +
                     variableEntries()}}}}}};
}

}
