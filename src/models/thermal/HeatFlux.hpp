/// Heat conduction, rho Cp dT/dt = div(kappa grad T), by the pair sum of scalars (ScalarFlux.hpp), with kappa for rho_0 D and the heat capacity m Cp for m:
///
///   m_i Cp_i dT_i/dt = sum_j kappa_ij (V_i^2 + V_j^2) (dW_ij/dr)/r_ij (T_i - T_j),    kappa_ij = 2 kappa_i kappa_j/(kappa_i + kappa_j)
///
/// T [K], Cp [J/(kg K)], kappa [W/(m K)], m [kg], V = 1/sigma [m^3], W [1/m^3]. The harmonic mean is that of Cleary & Monaghan (1999), J. Comput. Phys. 148,
/// 227: temperature and heat flux are continuous where kappa jumps. Pairs exchange what they lose: sum m_i Cp_i T_i changes by what walls give alone, to
/// round-off. With a normalised gradient (KernelMoment.hpp) of order 2.
///
/// The heat received from wall w alone [J/kg], whose sum over all particles is the heat through that wall [J]:
///
///   dh_i/dt = 1/m_i sum_j kappa_ij (V_i^2 + V_j^2) (dW_ij/dr)/r_ij (T_i - T_j),    j behind wall w
///
/// Verified by test/unit/thermal (plain loop, decay of a wave, slab, two phases, heat balance) and tutorials/verification/heatedCavity.
#pragma once
#include "models/scalarTransport/ScalarFlux.hpp"
#include "models/thermal/ThermalProperties.hpp"

namespace sph
{

/// T_i - T_j where no wall is heated, and mirrored images exchange pairwise.
struct TemperatureDifference
{
    template<class Conductivity> using Reads = typename Conductivity::template Reads<Temperature>;
    double difference(const auto& i, const auto& j) const { return i.T - j.T; }
};

/// share (T_i - T_j), by the place of j: 0 in the fluid, 1 + w behind a heated wall, the last one where a ghost has no part (HeatedWall).
struct TemperatureDifferenceByWall
{
    template<class Conductivity> using Reads = typename Conductivity::template Reads<Temperature, HeatedWall>;
    const double* share;
    double difference(const auto& i, const auto& j) const { return share[int(j.heatedWall)] * (i.T - j.T); }
};

}
