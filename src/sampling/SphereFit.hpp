/// Circles, spheres, ellipses and ellipsoids near to a set of points.
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

/// The circle (2-D) or sphere nearest to a set of points, in the least squares of their distances from it, each with its weight; all of the same without weights.
///
/// Starts from the linear fit of |x|^2 - 2 c.x = R^2 - c^2 (Kasa 1976), which makes short noisy arcs too small, and goes on with
/// Gauss-Newton on |x - c| - R, which does not.
SphereFit fitSphere(std::span<const Vector<3>> points, int dimension, std::span<const double> weights = {});

struct EllipsoidFit
{
    Vector<3> centre;
    Vector<3> semiAxes; ///< longest first [m]; 0 where the points do not determine an ellipsoid
};

/// The ellipse (2-D) or ellipsoid A:xx + b.x + c = 0 with tr A = dimension, in the least squares of the left side: exact of exact points, of noisy ones a little small (as the fit of Kasa (1976), which it is
/// where the axes are equal).
EllipsoidFit fitEllipsoid(std::span<const Vector<3>> points, int dimension, std::span<const double> weights = {});

}
