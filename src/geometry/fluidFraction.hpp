/// Fluid fraction of a domain with walls.
#pragma once
#include "geometry/Geometry.hpp"

namespace sph
{

/// Volume of the fluid over that of the domain, by n points of an additive recurrence with the generalised golden ratio (Roberts 2018): evenly spread, so
/// that their error is that of many more random ones.
double fluidFraction(const Geometry&, int n);

}
