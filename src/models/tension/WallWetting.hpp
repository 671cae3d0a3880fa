/// Contact angle of a liquid alone (`gas none;`), as a curvature: at a distance d from a wall its free surface is pulled as if it were more curved by
///
///   k_w = sum_(walls within R of i) cos(theta) Phi(d)/N        Phi of wallLayer.hpp,    R = 1.4 H
///
/// The force that the free surface has for it, -gamma k_w phi n (FreeSurfaceCurvature.hpp), adds up to gamma cos(theta) along the wall for each length of the line of contact, whatever the angle of the surface, since
/// Phi/N integrates to 1 over d: it is Young's force. At rest kappa + k_w is the same all over the surface, which turns by 90 degrees - theta within R of the wall, where it meets its mirror image. WallPotential is the same
/// energy, with a pressure gamma cos(theta) Phi in all of the liquid at the wall more, which presses particles onto their own images there: lines of contact then hardly move (README.md of models/gas).
///
/// R: a surface that turns within H does so by curvatures that sums over H do not resolve. With the curvature of the row beside the wall as FreeSurfaceCurvatureAtWalls has it, half balls of 12 spacings to the radius (support 3) come to 30.7, 59.5,
/// 90.1 and 118.2 degrees for 30, 60, 90 and 120 with R = 1.4 H; with 3/2 H and the row beside planes of symmetry as beside walls to 33.4, 60.1, 90.1 and 118.5.
///
/// N: integral of Phi over the fluid's side of the wall (wallLayer.hpp), times what the sum over rows of particles at d_0, d_0 + dx, ... has more than the integral; d_0 is the distance at
/// which walls hold particles (WallContact.hpp), where the suction at a line of contact draws them.
#pragma once
#include "fields/fieldTags.hpp"
#include "models/tension/WettingAngles.hpp"
#include "models/tension/wallLayer.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

struct WettingCurvature
{
    static constexpr FieldInfo info{"wettingCurvature", "1/m"};
    template<int dim, class Real = double> struct At
    {
        Real k_w;
    };
};

struct WallWetting
{
    static constexpr bool atWalls = true;
    static constexpr auto name = "wallWetting";
    static constexpr double reachInSupports = 1.4;
    using Provides = WettingCurvature;
    const double* cosTheta; ///< of each wall
    WallLayer layer;
    double rows = 0; ///< sum of Phi dx over rows of particles

    /// `closest`: d_0 [m].
    WallWetting(const Coefficients& c, double closest) : cosTheta(c.of<WettingAngles>().cosine.data()), layer{reachInSupports * c.support}
    {
        for (double d = closest; d < layer.R; d += c.spacing) rows += layer.phi(d) * c.spacing;
    }
    double wallReach() const { return layer.R; }
    auto operator()(double soFar, const auto&, const auto& foot) const
    {
        if (foot.distance >= layer.R) return soFar;
        const double curved = foot.uniformlyCurved ? 1 : 0;
        return soFar + cosTheta[foot.wall] * layer.phi(foot.distance) / (rows * layer.integral(curved * foot.k1, curved * foot.k2));
    }
};

}
