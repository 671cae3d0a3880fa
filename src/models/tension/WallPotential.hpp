/// Contact angle as a potential of the wall, the same energy as WallTension's but felt along the normal:
///
///   dv_i/dt += -1/rho_k sum_(walls within H of i) gamma_sk/N dPhi/dd n
///   Phi, N = int_0^H Phi (1 - k_1 d)(1 - k_2 d) dd of a layer as deep as H (wallLayer.hpp)
///
/// n [-] normal and d [m] distance of the wall, gamma_sk [N/m] its tension with the particle's phase k, rho_k [kg/m^3] that phase's rest
/// density. Phi [1/m] integrates to 1 over the fluid's side of a plane, Phi/N over that of spheres and cylinders of the curvatures k_1 and k_2 [1/m]
/// (Shape.hpp), whose area grows or shrinks with d: covered by phase k they store gamma_sk. Without N grains of 8 to 16 spacings a radius had 5 to
/// 20 % too much. Where the curvature varies along the surface N is 1: a force along the normal alone would do work on a closed way. Phi is flat
/// at H and at the wall: no step in the force, ghosts need no rule of their own, and nothing is pulled through the wall (Phi over the area at d
/// in place of N does: at 30 spacings a period an eighth of the water in tutorials/heapLeaching/bccBed sank into the spheres). d is that of the
/// nearest place of each body, its edges included: the force of a box is the gradient of one potential, and a liquid around its corner is at rest.
///
/// The force has an energy whatever the particles' arrangement: liquid bodies of a few spacings stay on the wall, where the stress
/// works them loose and stirs the gas (tutorials/heapLeaching/bccBed). The interface must bend within H of the wall: the curvature form
/// does, and has angles within 3 degrees; the interface stress does not, and has them too far from 90 (tutorials/verification/contactAngle).
#pragma once
#include "fields/fieldTags.hpp"
#include "models/tension/Tensions.hpp"
#include "models/tension/wallLayer.hpp"
#include "plan/Coefficients.hpp"
#include <cmath>

namespace sph
{

struct WallPotential
{
    static constexpr bool atWalls = true;
    static constexpr auto name = "wallPotential";
    using Adds = Acceleration;
    using ReadsOwn = Fields<Phase>;
    const double *tension, *restDensity; ///< [N/m], walls x phases; [kg/m^3]
    std::size_t phases;
    WallLayer layer;

    explicit WallPotential(const Coefficients& c)
        : tension(tensionsOf(c).ofWalls.data()), restDensity(c.restDensity.data()), phases(c.phases.size()), layer{c.support}
    {}
    /// dPhi/dd/N [1/m^2] at the distance d [m] from a surface of the given principal curvatures [1/m]
    double slope(double d, double k1, double k2) const
    {
        if (std::fabs(d) >= layer.R || 1 - k1 * d < WallLayer::least || 1 - k2 * d < WallLayer::least) return 0;
        return layer.slope(d) / layer.integral(k1, k2);
    }
    double wallReach() const { return layer.R; }
    auto operator()(auto dvdt, const auto& i, const auto& foot) const
    {
        const auto k = std::size_t(i.phase);
        const double curved = foot.uniformlyCurved ? 1 : 0;
        const double gamma = tension[std::size_t(foot.wall) * phases + k];
        return dvdt += -gamma / restDensity[k] * slope(foot.distance, curved * foot.k1, curved * foot.k2) * foot.normal;
    }
};

}
