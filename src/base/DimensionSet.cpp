#include "base/DimensionSet.hpp"
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sph
{

std::string toString(const DimensionSet& d) { return fmt::format("[{}]", fmt::join(d.exponent, " ")); }

}
