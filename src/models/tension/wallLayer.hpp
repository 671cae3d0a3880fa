/// The layer of fluid along a wall that laws of contact angles act in:
///
///   Phi(d) = 35/(16 R) (1 - (d/R)^2)^3,    int_0^R Phi (1 - k_1 d)(1 - k_2 d) dd = 1 - 35/128 R (k_1 + k_2) + R^2/9 k_1 k_2
///
/// d [m] distance from the wall, R [m] depth of the layer, k_1 and k_2 [1/m] principal curvatures of the wall (Shape.hpp). Phi [1/m] integrates to 1 over the fluid's side of a plane, and is flat at R and at the wall.
#pragma once
#include "base/Vector.hpp"
#include <cmath>

namespace sph
{

struct WallLayer
{
    double R;

    double phi(double d) const
    {
        const double left = 1 - sqr(d / R);
        return left > 0 ? 35.0 / 16 / R * left * left * left : 0;
    }
    /// dPhi/dd [1/m^2], within R.
    double slope(double d) const
    {
        const double s = d / R, left = 1 - sqr(s);
        return -105.0 / 8 / sqr(R) * s * sqr(left);
    }
    /// The integral; at least 0.1, since nearer to a centre of curvature there is no image either.
    double integral(double k1, double k2) const { return std::fmax(1 - 35.0 / 128 * R * (k1 + k2) + sqr(R) / 9 * k1 * k2, least); }
    static constexpr double least = 0.1;
};

}
