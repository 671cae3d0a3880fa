/// Continuity equation, each pair weighed by the neighbour's volume:
///
///   drho_i/dt = rho_i sum_j V_j (v_i - v_j) . gradW_ij
///
/// rho [kg/m^3], V [m^3], v [m/s]. Exact for rigid translation. Verified by test/unit/density (plain loop; uniform expansion).
#pragma once
#include "fields/fieldTags.hpp"

namespace sph
{

struct Continuity
{
    static constexpr auto name = "continuity";
    using Adds = DensityRate;
    using Reads = Fields<Volume, Velocity>;
    using ReadsOwn = Fields<Density>;
    static constexpr bool bearsSingle = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return i.rho * j.V * dot(i.v - j.v, ij.gradW); }
};

/// Each pair weighed by the neighbour's mass, Monaghan (1994), as eq. (3.1) of Kauzlaric et al. (2011):
///
///   drho_i/dt = sum_j m_j (v_i - v_j) . gradW_ij
///
/// The derivative of rho_i = sum_j m_j W_ij, so that density and places of the particles part by the integration alone. m [kg], v [m/s]. Exact for rigid
/// translation; where the density jumps it smears the jump, as the form above does not. Verified by test/unit/density (plain loop).
struct MassContinuity
{
    static constexpr auto name = "massContinuity";
    using Adds = DensityRate;
    using Reads = Fields<Mass, Velocity>;
    static constexpr bool bearsSingle = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return j.m * dot(i.v - j.v, ij.gradW); }
};

/// Volume where the density is integrated:
///
///   V_i = m_i/rho_i
///
/// Inside a fluid the volume by number density is the better weight of sums: with it the
/// viscous decay of Taylor-Green's vortices is a quarter as far off (`volume numberDensity;`); at a free surface it is not.
struct IntegratedVolume
{
    static constexpr auto name = "integratedVolume";
    using Provides = Volume;
    using ReadsOwn = Fields<Mass, Density>;
    auto operator()(const auto& i) const { return i.m / i.rho; }
};

}
