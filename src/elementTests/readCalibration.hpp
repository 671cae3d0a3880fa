/// The section `calibration` of system/elementTestDict: constants of law wuBauer from one test, or of any law from several.
#pragma once
#include "case/Case.hpp"
#include "dictionary/EntryList.hpp"
#include "elementTests/calibrate.hpp"
#include "elementTests/fitConstants.hpp"

namespace sph
{

/// Whether it has `tests`, which readFit reads; else readMeasurement does.
bool hasMeasuredTests(const Case&);
/// Mistakes go to the case's Diagnostics.
Measurement readMeasurement(const Case&);
FitPlan readFit(const Case&, const SoilLaw&);
/// constant/soilProperties with other values of those constants; and the values that are there.
Soil readSoilWith(const Case&, const std::vector<FittedConstant>&, const std::vector<double>&);
std::vector<double> startOf(const Case&, const std::vector<FittedConstant>&);
/// `a.b` with its value as a dictionary writes it, a { b value; }.
std::string entryAs(const std::string& path, const std::string& value);
/// The section with its entries.
EntryList calibrationEntries();

}
