/// Buoyancy of a fluid whose density differs little from that at rest, after Boussinesq:
///
///   dv/dt = -beta (T - T0) g,    rho(T) = rho_0 (1 - beta (T - T0)) in the weight alone
///
/// beta [1/K] thermal expansion coefficient, T [K], T0 [K] temperature at which the density is rho_0, g [m/s^2]. Valid for |beta (T - T0)| << 1; Landau &
/// Lifshitz, Fluid Mechanics, section 56. The weight of fluid at T0 is that of `gravity` (forces). Verified by test/unit/thermal and
/// tutorials/verification/heatedCavity.
#pragma once
#include "models/thermal/ThermalProperties.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

/// One beta everywhere.
struct UniformExpansion
{
    using Reads = Fields<Velocity, Temperature>;
    double beta;
    double of(const auto&) const { return beta; }
};

struct ExpansionOfPhases
{
    using Reads = Fields<Velocity, Temperature, Phase>;
    const double* beta; ///< of each phase
    double of(const auto& i) const { return beta[int(i.phase)]; }
};

template<class Expansion> struct Buoyancy
{
    static constexpr auto name = "buoyancy";
    using Adds = Acceleration;
    using ReadsOwn = typename Expansion::Reads;
    Expansion expansion;
    double T0;
    const Vector<3>& g;

    auto operator()(const auto& i) const { return -expansion.of(i) * (i.T - T0) * in<dimensions(decltype(i.v){})>(g); }
};

}
