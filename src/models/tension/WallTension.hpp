/// Contact angle as a tension that the wall exerts on the fluid next to it:
///
///   S_w,i = sum_(walls within H of i) 2 gamma_sk w_1(d) (I - n n),    w_1(d) = integral of W over the plane at distance d
///
/// n [-] normal and d [m] distance of the wall, gamma_sk [N/m] its tension with the particle's phase k, w_1 [1/m] the kernel's marginal:
/// 2 w_1 integrates to 1 over the fluid's side, so that a wall covered by phase k carries gamma_sk. With gamma_sl - gamma_sg =
/// -gamma cos(theta), ghosts of their parents' phase and their parents' stress mirrored, fluid plus image carries no shear across the wall:
/// Young's law is then the tangential momentum balance itself. 2 w_1(d) n is what the sum over the ghosts of a plane wall gives
/// for its colour gradient; taken from the wall itself it needs no sum, has no noise, and keeps two walls apart whose ghosts meet in
/// the pinch between grains, where the summed normal means nothing.
///
/// At a curved wall nothing changes to first order in k d, k [1/m] a curvature of the wall. Outside a circle of radius R the layer at distance d is
/// longer by d/R, and so is its lever about the centre; but the layer presses on the wall, and the pressure that bears it,
/// p = integral of S_w,tt/r from r = R + d on, takes off what that adds: the moment of both about the centre is gamma_sk times the mean of
/// (R^2 + r^2)/(2 r) over the layer, R to second order in d/R, and spheres and cylinders give the same. Measured at 60 and 120 degrees with R/H = 3: none is
/// within 1 degree, a factor of R/r or its inverse 2 to 4 degrees off (tutorials/verification/contactAngle, circles).
#pragma once
#include "fields/fieldTags.hpp"
#include "models/tension/Tensions.hpp"
#include "plan/Coefficients.hpp"
#include <algorithm>
#include <string>
#include <vector>

namespace sph
{

/// w_1(d) [1/m] of a kernel at equal steps of d from 0 to H.
struct KernelMarginal
{
    std::vector<double> w_1;
    static KernelMarginal of(const std::string& kernel, int dimension, double H);
};

struct WallTension
{
    static constexpr bool atWalls = true;
    static constexpr auto name = "wallTension";
    using Adds = Stress;
    using ReadsOwn = Fields<Phase>;
    const double* tension; ///< [N/m], walls x phases
    std::size_t phases;
    double H;
    const std::vector<double>* w_1;

    explicit WallTension(const Coefficients& c)
        : tension(tensionsOf(c).ofWalls.data()), phases(c.phases.size()), H(c.support), w_1(&c.of<KernelMarginal>().w_1)
    {}
    double marginal(double d) const
    {
        const auto& w = *w_1;
        const double place = std::clamp(d / H, 0.0, 1.0) * double(w.size() - 1);
        const auto k = std::min(std::size_t(place), w.size() - 2);
        return w[k] + (place - double(k)) * (w[k + 1] - w[k]);
    }
    double wallReach() const { return H; }
    /// The law acts only where there is a mirror image, which the tension has to balance.
    auto operator()(auto S, const auto& i, const auto& foot) const
    {
        if (foot.distance >= H || !foot.smooth) return S;
        const double gamma = tension[std::size_t(foot.wall) * phases + std::size_t(i.phase)];
        return S += 2 * gamma * marginal(foot.distance) * (identity(foot.normal) - outer(foot.normal));
    }
};

}
