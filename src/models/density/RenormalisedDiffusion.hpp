/// Density diffusion of delta-SPH, Antuono et al. (2010), eq. (5): that of Molteni & Colagrossi less what a linear density would diffuse.
///
///   drho_i/dt += delta h c sum_j 2 (rho_i - rho_j - 1/2 (grad rho_i + grad rho_j).x_ij) (x_ij . gradW_ij)/(r_ij^2 + 0.01 h^2) V_j
///   grad rho_i = [sum_j V_j (x_j - x_i) gradW_ij]^-1 sum_j V_j (rho_j - rho_i) gradW_ij
///
/// Sums go over the fluid and not over ghosts of walls: these have their sources' density, which is no continuation of a hydrostatic
/// one. The tensor makes the gradient exact for a linear density also where neighbours are missing; where there are too few (determinant
/// below 0.05) it is 0, and the form that of Molteni. Without the correction a tank at rest sinks under its own weight: measured on 20
/// spacings of depth, the centre of mass by 1.1 % in 26 sqrt(depth/g), and by 0.15 % with it.
///
/// delta about 0.1, h = H/2 [m], c [m/s] the largest sound speed, V [m^3]. sum V_i drho_i/dt = 0 exactly. Verified by test/unit/density
/// (plain loop; nothing diffuses in a linear density).
#pragma once
#include "models/density/DensityDiffusion.hpp"

namespace sph
{

/// Sums of which the gradient at a particle is made.
template<int dim> struct LinearFit
{
    SymmTensor<dim> B;
    Vector<dim> gradient;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.B, q.gradient); }
};

struct RenormalisedDensityGradient
{
    static constexpr auto name = "renormalisedDensityGradient";
    using Provides = DensityGradient;
    using Reads = Fields<Density, Volume, GhostWall>;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const double w = j.wall > 0 ? 0.0 : j.V;
        return LinearFit<dimensions(decltype(ij.x){})>{-w * ij.dWdrOverR * outer(ij.x), w * (j.rho - i.rho) * ij.gradW};
    }
    auto finish(const auto&, const auto& fit) const
    {
        const double det = determinant(fit.B);
        return (det > 0.05 ? 1 / det : 0.0) * (adjugate(fit.B) * fit.gradient);
    }
};

struct RenormalisedDiffusion : DensityDiffusion
{
    static constexpr auto name = "renormalisedDiffusion";
    using Reads = Fields<Density, Volume, DensityGradient, GhostWall>;

    using DensityDiffusion::DensityDiffusion;
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const auto w = j.wall > 0 ? decltype(j.V){} : j.V;
        const auto difference = i.rho - j.rho - 0.5 * dot(i.gradRho + j.gradRho, ij.x);
        return coefficient * difference * dot(ij.x, ij.gradW) / (ij.rr + small) * w;
    }
};

}
