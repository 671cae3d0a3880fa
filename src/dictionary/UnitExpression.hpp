/// The text between the brackets of a dimensioned value.
#pragma once
#include "base/DimensionSet.hpp"
#include <string>

namespace sph
{

/// "0 2 -1 0 0 0 0" (or the first five exponents), or units: "m^2/s", "kg m^-3", "Pa s", "J/(kg K)", "-" for none; a division
/// holds for the unit or bracket that follows. SI units without prefixes alone, so that values never need conversion. Throws
/// std::invalid_argument: what is wrong.
DimensionSet parseDimensions(const std::string& text);

}
