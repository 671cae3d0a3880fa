/// Element tests, as system/elementTestDict states them:
///
///     tests
///     {
///         oedometer { type oedometer; pressure 1e5; strain (0.02); points 20; }
///         ...
///     }
///     plots yes;
#pragma once
#include "case/Case.hpp"
#include "elementTests/ElementTest.hpp"
#include "elementTests/calibrate.hpp"
#include "elementTests/fitConstants.hpp"

namespace sph
{

inline const std::string elementTestDictionary = "system/elementTestDict";

struct ElementTestPlan
{
    std::vector<ElementTest> tests;
    bool plots = true;
};

/// Mistakes go to the case's Diagnostics. Tests are checked against the law: a start that it does not admit is an error.
ElementTestPlan readElementTests(const Case&, const SoilLaw&);
/// The section `calibration`: of law wuBauer from one test, or of any law from several.
bool hasMeasuredTests(const Case&);
Measurement readMeasurement(const Case&);
FitPlan readFit(const Case&, const SoilLaw&);
/// constant/soilProperties with other values of those constants; and the values that are there.
Soil readSoilWith(const Case&, const std::vector<FittedConstant>&, const std::vector<double>&);
/// `a.b` with its value as a dictionary writes it, a { b value; }.
std::string entryAs(const std::string& path, const std::string& value);
std::vector<double> startOf(const Case&, const std::vector<FittedConstant>&);
EntryList elementTestEntries();

}
