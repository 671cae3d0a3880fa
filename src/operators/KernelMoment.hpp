/// Moment of the kernel's slope, which tells how far the slope is from its continuum value in the arrangement at hand:
///
///   M_i = -1/d sum_j W'_ij r_ij,    N_i = M_i V_i      -> 1 in the continuum
///
/// N is what a sum V_j q_ij gradW_ij makes of a linear q, and a Morris sum of a parabola: 0.975 to 0.99 on lattices of support 2.6 to 3
/// spacings, at any resolution. With `normalisation secondMoment` the stencil divides gradW by (N_i + N_j)/2 in every pass that knows N:
/// pressure, viscosity, stress and colour gradients are then consistent with one another, and pairs stay antisymmetric, so that
/// linear momentum is conserved exactly. Measured (tutorials/verification): without it plane Poiseuille keeps 4 %, a hydrostatic column
/// 2.3 %, the Laplace jump of the stress form -3 % however fine the resolution.
///
/// M [1/m^d], d dimensions, W' = dW/dr. N is 0.9 at a free surface, and 0 for a particle alone: with less than half the neighbours of a bulk
/// there is nothing to normalise, and 1/N would make spray fly apart, so that N stays above `least`.
#pragma once
#include "fields/fieldTags.hpp"
#include <cmath>

namespace sph
{

struct SecondMoment
{
    static constexpr auto name = "secondMoment";
    using Provides = KernelMoment;
    static constexpr bool bearsSingle = true;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto&, const auto&) const { return -1.0 / dimensions(ij.x) * ij.dWdrOverR * ij.rr; }
};

struct GradientNormalisation
{
    static constexpr auto name = "gradientNormalisation";
    using Provides = GradientScale;
    using ReadsOwn = Fields<KernelMoment, Volume>;

    static constexpr double least = 0.5;
    auto operator()(const auto& i) const { return std::fmax(least, i.M * i.V); }
};

}
