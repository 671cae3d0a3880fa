/// Contact angle of a liquid alone (`gas none;`), as a curvature: at a distance d from a wall its free surface is pulled as if it were more curved by
///
///   k_w = sum_(walls within R of i) cos(theta) Phi(d)/N        Phi(d) = 35/(16 R) (1 - (d/R)^2)^3,    R = 3/2 H
///
/// The force that the free surface has for it, -gamma k_w phi n (FreeSurfaceCurvature.hpp), adds up to gamma cos(theta) along the wall for each length of the line of contact, whatever the angle of the surface, since
/// Phi/N integrates to 1 over d: it is Young's force. At rest kappa + k_w is the same all over the surface, which turns by 90 degrees - theta within R of the wall, where it meets its mirror image. WallPotential is the same
/// energy, with a pressure gamma cos(theta) Phi in all of the liquid at the wall more, which presses particles onto their own images there: lines of contact then hardly move (README.md of models/gas).
///
/// R: a surface that turns within H does so by curvatures that sums over H do not resolve. A half ball of 12 spacings to the radius (support 3) comes to 57.0 degrees for 60 with R = H, 59.1 with 3/2 H, 61.9 with 2 H; for 30
/// to 17, 32.5 and 43.
///
/// N: integral of Phi over the fluid's side of a wall of the curvatures k_1 and k_2 [1/m] (WallPotential.hpp), times what the sum over rows of particles at d_0, d_0 + dx, ... has more than the integral; d_0 is the distance at
/// which walls hold particles (WallContact.hpp), where the suction at a line of contact draws them.
#pragma once
#include "fields/fieldTags.hpp"
#include "models/tension/WettingAngles.hpp"
#include "plan/Coefficients.hpp"
#include <cmath>

namespace sph
{

struct WettingCurvature
{
    static constexpr FieldInfo info{"wettingCurvature", "1/m"};
    template<int dim> struct At
    {
        double k_w;
    };
};

struct WallWetting
{
    static constexpr bool atWalls = true;
    static constexpr auto name = "wallWetting";
    static constexpr double reachInSupports = 1.5;
    using Provides = WettingCurvature;
    const double* cosTheta; ///< of each wall
    double R, rows = 0;     ///< [m]; sum of Phi dx over rows of particles

    /// `closest`: d_0 [m].
    WallWetting(const Coefficients& c, double closest) : cosTheta(c.of<WettingAngles>().cosine.data()), R(reachInSupports * c.support)
    {
        for (double d = closest; d < R; d += c.spacing) rows += phi(d) * c.spacing;
    }
    double phi(double d) const
    {
        const double left = 1 - sqr(d / R);
        return left > 0 ? 35.0 / 16 / R * left * left * left : 0;
    }
    auto operator()(double soFar, const auto&, const auto& foot) const
    {
        if (foot.distance >= R) return soFar;
        const double curved = foot.uniformlyCurved ? 1 : 0, k1 = curved * foot.k1, k2 = curved * foot.k2, least = 0.1;
        const double N = rows * (1 - 35.0 / 128 * R * (k1 + k2) + sqr(R) / 9 * k1 * k2);
        return soFar + cosTheta[foot.wall] * phi(foot.distance) / std::fmax(N, least);
    }
};

}
