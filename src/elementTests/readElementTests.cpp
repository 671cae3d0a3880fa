#include "elementTests/readElementTests.hpp"
#include "elementTests/readCalibration.hpp"
#include "elementTests/testTypes.hpp"
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const SubDictionary tests{"tests", notGiven, "element tests by names of the case's own"};
const FreeName test{"<test>", "dictionary", "a test, whose name is that of its file"};
const Count points{"points", 100, Range{1, 1e6}, "rows of each piece of the path"};
const Count cycles{"cycles", 1, Range{1, 1e6}, "how often the list is gone through"};
const SubDictionary stages{"stages", byScene("of type"), "pieces one after another, in place of type: consolidate, then shear"};
const FreeName stage{"<stage>", "dictionary", "a piece by a name of the case's own"};
const FileName path{"file", "", required,
                    "table with columns of xx xy xz yy yz zz, strains from the start on, extension positive; what has no column is 0"};
const Switch plots{"plots", true, "draw the tests, by gnuplot"};
}

namespace
{

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

EntryList elementTestEntries()
{
    const EntryList piece{{entry::type, typeCases()}};
    return EntryList{{entry::tests,
                      {{entry::test, piece + startEntries() + EntryList{{entry::stages, {{entry::stage, piece}}}, entry::points}}}},
                     entry::plots} +
           calibrationEntries();
}

}
