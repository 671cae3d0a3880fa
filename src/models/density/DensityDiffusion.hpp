/// Density diffusion against the pressure noise of the integrated density: Molteni & Colagrossi (2009).
///
///   drho_i/dt += delta h c sum_j 2 (rho_i - rho_j) (x_ij . gradW_ij)/(r_ij^2 + 0.01 h^2) V_j
///
/// delta about 0.1, h = H/2 [m], c [m/s] the largest sound speed, V [m^3]. Between particles of like rest density only: where it
/// differs the density jumps for good. Verified by test/unit/density (sign, decay) and tutorials/verification/hydrostatic.
#pragma once
#include "fields/fieldTags.hpp"
#include "plan/Coefficients.hpp"
#include "scene/soundDamping.hpp"
#include <algorithm>

namespace sph
{

struct DensityDiffusion
{
    static constexpr auto name = "densityDiffusion";
    using Adds = DensityRate;
    using Reads = Fields<Density, Volume>;
    static constexpr bool bearsSingle = true;
    double coefficient, small;

    explicit DensityDiffusion(const Coefficients& c)
        : coefficient(2 * c.of<DiffusionNumber>().delta * 0.5 * c.support * (*std::max_element(c.soundSpeed.begin(), c.soundSpeed.end()))),
          small(0.01 * sqr(0.5 * c.support))
    {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return coefficient * (i.rho - j.rho) * dot(ij.x, ij.gradW) / (ij.rr + small) * j.V;
    }
};

}
