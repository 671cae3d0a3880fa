/// The circle (2-D) or sphere nearest to a set of points, in the least squares of their distances from it.
#pragma once
#include "base/Vector.hpp"
#include <span>

namespace sph
{

struct SphereFit
{
    Vector<3> centre;
    double radius = 0; ///< 0 where the points do not determine a sphere
};

/// Starts from the linear fit of |x|^2 - 2 c.x = R^2 - c^2 (Kasa 1976), which makes short noisy arcs too small, and goes on with
/// Gauss-Newton on |x - c| - R, which does not.
SphereFit fitSphere(std::span<const Vector<3>> points, int dimension);

}
