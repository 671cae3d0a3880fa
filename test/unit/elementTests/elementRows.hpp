/// Rows of one element test, as the dictionaries of a case would have it.
#pragma once
#include "TestCase.hpp"
#include "elementTests/readCalibration.hpp"
#include "elementTests/readElementTests.hpp"
#include "soilTesting.hpp"

namespace sph::test
{

inline Files files(const std::string& tests)
{
    return {{"constant/soilProperties",
             "rho 1850; law wuBauer; wuBauerCoeffs { c1 -69.4; c2 -673.1; c3 -655.9; c4 699.6; } floorPressure 1e-3;\n"},
            {"system/elementTestDict", tests}};
}

inline std::vector<ElementRow> rowsOf(const std::string& test, const std::string& more, const std::string& law = "")
{
    auto all = files("tests { a { " + test + " } }");
    if (!law.empty()) all["constant/soilProperties"] = law;
    all["constant/soilProperties"] += more;
    const TestCase folder(all);
    const Case c(folder.folder());
    const auto soil = readSoil(c.dictionary(soilProperties), "within");
    const auto plan = readElementTests(c, soil.law);
    c.diagnostics().throwIfAny();
    return runElementTest(soil, plan.tests.at(0));
}

/// What the user is told of a test that cannot be.
inline std::string refusal(const std::string& test, const std::string& law)
{
    try
    {
        rowsOf(test, "", law);
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
    return "nothing: the test has run";
}

/// The row at this path.
inline const ElementRow& at(const std::vector<ElementRow>& rows, double path)
{
    for (const auto& row : rows)
        if (std::abs(row.path - path) < 1e-9) return row;
    throw std::logic_error("no row at " + std::to_string(path));
}

inline const std::string tightly = "tolerance 1e-10;";

}
