/// Relaxation of an integrated density, which forgets how far apart the particles lie. After a splash a liquid keeps its density and has more volume, for
/// the particles around it have been torn apart and come together as they may. Inside the fluid the density follows that of the particles' places, where the
/// two differ by more than e:
///
///   drho_i/dt += c/(n h) (rho_g - rho_i),    rho_g = m_i sum_j W_ij, brought nearer to rho_i by e rho_i
/// inside: |sum_j V_j gradW_ij| < 0.2/H and m_i sum_j W_ij > 0.5 rho_i, which leaves spray out, half of the latter by the fluid itself, which leaves out what is
/// alone in a corner or a crevice, between images of its own
///
/// Too thin a liquid is then under tension, and contracts. m [kg], V [m^3], h = H/2 [m], c [m/s] the largest sound speed, n [1] the time in which it follows, in
/// times of sound over h; e = 0.02, more than a lattice at rest or the disorder of a flow differ by. At rest there is none. Verified by test/unit/density (plain
/// loop) and test/accuracy/run damBreakByDefault.
#pragma once
#include "fields/fieldTags.hpp"
#include "plan/Coefficients.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

/// n of the density's relaxation.
struct RelaxationTime
{
    double soundTimes = 0;
};

template<int dim> struct SlopeAndNumber
{
    Vector<dim> slope;
    double number, ofFluid; ///< of all, and of the fluid without ghosts of walls
    static constexpr auto parts(auto& q, const auto& f) { return f(q.slope, q.number, q.ofFluid); }
};

struct DensityRelaxation
{
    static constexpr auto name = "densityRelaxation";
    using Adds = DensityRate;
    using Reads = Fields<Volume, GhostWall>;
    using ReadsOwn = Fields<Mass, Density>;
    static constexpr bool readsKernel = true;
    static constexpr double allowed = 0.02, thinnest = 0.5, leastFluid = 0.5;
    double rate, steepest;

    explicit DensityRelaxation(const Coefficients& c)
        : rate(*std::max_element(c.soundSpeed.begin(), c.soundSpeed.end()) / (c.of<RelaxationTime>().soundTimes * 0.5 * c.support)),
          steepest(0.2 / c.support)
    {}
    auto operator()(const auto& ij, const auto&, const auto& j) const
    {
        constexpr int dim = dimensions(decltype(ij.x){});
        return SlopeAndNumber<dim>{j.V * ij.gradW, ij.W, j.wall > 0 ? 0.0 : ij.W};
    }
    auto finish(const auto& i, const auto& sum) const
    {
        const double ofPlaces = i.m * sum.number, excess = ofPlaces - i.rho, band = allowed * i.rho;
        const double beyond = excess - std::fmax(-band, std::fmin(band, excess));
        const bool inside = mag(sum.slope) < steepest && ofPlaces > thinnest * i.rho && sum.ofFluid > leastFluid * sum.number;
        return inside ? rate * beyond : 0.0;
    }
};

}
