/// Where terms of pairs can be computed in single precision.
#pragma once
#include "geometry/Geometry.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

/// Least spacing [m]: products of a solve go with V^2 m c^2, 1e-51 J m^6 of a gas at 1 um, and floats end at 1e-38; the terms keep what they sum above that, down to this spacing.
inline constexpr double leastSpacingOfSingle = 1e-6;
/// Most extent of a domain [spacings]: places are multiples of 2^-30 of it (neighbours/records.hpp), here 1e-4 spacings.
inline constexpr double mostExtentOfSingle = 1e5;

/// Why it cannot; empty where it can.
inline std::string singlePrecisionFails(double spacing, const Geometry& geometry)
{
    if (spacing < leastSpacingOfSingle)
        return fmt::format("single precision holds the terms of pairs down to a spacing of {:.3g} m, and it is {:.3g} m here",
                           leastSpacingOfSingle, spacing);
    const auto size = geometry.high - geometry.low;
    const double extent = std::max({size.x, size.y, geometry.dimension == 3 ? size.z : 0.0}) / spacing;
    if (extent > mostExtentOfSingle)
        return fmt::format("places in single precision are multiples of 2^-30 of the domain, enough for {:.3g} spacings, and it has {:.3g}",
                           mostExtentOfSingle, extent);
    return {};
}

}
