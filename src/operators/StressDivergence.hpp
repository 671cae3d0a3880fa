/// Acceleration by a stress, shared by all models that have one (surface tension, soil).
///
///   dv_i/dt = 1/m_i sum_j (S_i V_i^2 + S_j V_j^2) . gradW_ij
///
/// S [Pa] tension positive, V [m^3], m [kg]. Conserves linear momentum exactly. Verified by test/unit/passes (plain loop, momentum).
#pragma once
#include "fieldTags.hpp"

namespace sph
{

struct StressDivergence
{
    static constexpr auto name = "stressDivergence";
    using Adds = Acceleration;
    using Reads = Fields<Stress, Volume>;
    using ReadsOwn = Fields<Mass>;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return 1/i.m*((sqr(i.V)*i.S + sqr(j.V)*j.S)*ij.gradW); }
};

}
