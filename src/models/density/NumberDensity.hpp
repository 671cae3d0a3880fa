/// Particle volume from the number density: Hu & Adams (2006), eq. (19) of Barker et al. (2012).
///
///   sigma_i = a sum_j w_j W_ij (j = i included),   V_i = 1/sigma_i
///
/// sigma [1/m^d]; W [1/m^d] kernel; w_j volume factor of a ghost, 1 for fluid, already in W_ij; a makes the mean of sigma V_0 exact over the packing
/// (without it V^2 is 2 % low). No density enters the sum, so that a density ratio of 1000 is as smooth as none.
/// Verified by test/unit/plan (plain loop) and tutorials/verification/hydrostatic.
#pragma once
#include "fields/fieldTags.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

struct NumberDensity
{
    static constexpr auto name = "numberDensity";
    using Provides = Volume;
    static constexpr bool bearsSingle = true;
    static constexpr bool readsKernel = true; // W itself; all other terms use its gradient
    static constexpr bool ofRawGradient = true;
    double a;

    explicit NumberDensity(const Coefficients& c) : a(c.densityScale) {}
    auto operator()(const auto& ij, const auto&, const auto&) const { return ij.W; }
    auto finish(const auto&, double sum) const { return 1 / (a * sum); }
};

/// Density of the particle by its volume, eq. (7) of Barker et al. (2012):
///
///   rho_i = m_i/V_i
struct SummedDensity
{
    static constexpr auto name = "summedDensity";
    using Provides = Density;
    using ReadsOwn = Fields<Mass, Volume>;
    auto operator()(const auto& i) const { return i.m / i.V; }
};

}
