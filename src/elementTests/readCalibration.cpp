#include "elementTests/readCalibration.hpp"
#include "base/words.hpp"
#include "dictionary/DictionaryNode.hpp"
#include "elementTests/readElementTests.hpp"
#include "elementTests/testTypes.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sph
{

namespace
{

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
const Choice measuredType{"type", wordsOf(measuredCases()), required, "what was done to the soil"};
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

EntryList calibrationEntries()
{
    return {{entry::calibration,
             {entry::lateral,
              entry::initialStiffness,
              entry::initialVolumeSlope,
              entry::peak,
              entry::peakVolumeSlope,
              entry::measured,
              {entry::constants, {entry::constant}},
              {entry::measuredTests,
               {{entry::measuredTest, EntryList{{entry::measuredType, measuredCases()}, entry::curves} + startEntries()}}}}}};
}

}
