/// Acceleration by a stress, shared by all models that have one (surface tension, soil).
///
///   dv_i/dt = 1/m_i sum_j (S_i V_i^2 + S_j V_j^2) . gradW_ij
///
/// S [Pa] tension positive, V [m^3], m [kg]. Conserves linear momentum exactly. Verified by test/unit/plan (plain loop, momentum).
#pragma once
#include "fieldTags.hpp"

namespace sph
{

template<class OfStress> struct DivergenceOf
{
    using Adds = Acceleration;
    using Reads = Fields<OfStress, Volume>;
    using ReadsOwn = Fields<Mass>;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return 1 / i.m * ((sqr(i.V) * i.S + sqr(j.V) * j.S) * ij.gradW); }
};
struct StressDivergence : DivergenceOf<Stress>
{
    static constexpr auto name = "stressDivergence";
};

/// The pair's stress weighed by the densities, as the density-weighted pressure weighs p (S = -p I gives that form):
///
///   dv_i/dt = 1/m_i sum_j (V_i^2 + V_j^2) (rho_j S_i + rho_i S_j)/(rho_i + rho_j) . gradW_ij
///
/// Across an interface of 1000:1 the light side then does not carry the heavy side's stress: the wall tension of a liquid, which the plain
/// form hands on to the gas beside the contact line, accelerated that gas to tens of metres a second in a bed of 1 mm spheres.
struct DensityWeightedStressDivergence
{
    static constexpr auto name = "densityWeightedStressDivergence";
    using Adds = Acceleration;
    using Reads = Fields<Stress, Volume, Density>;
    using ReadsOwn = Fields<Mass>;

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return (sqr(i.V) + sqr(j.V)) / (i.m * (i.rho + j.rho)) * ((j.rho * i.S + i.rho * j.S) * ij.gradW);
    }
};

}
