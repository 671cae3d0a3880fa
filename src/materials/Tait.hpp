/// State equation of Tait, per phase: eq. (7) ff. of Barker et al. (2012) after Becker & Teschner (2007).
///
///   p = max(B ((rho/rho_0)^n - 1) + p_b, p_min),   B = rho_0 c^2/n
///
/// p [Pa], rho [kg/m^3], rho_0 rest density, c [m/s] sound speed at rest density; n = 7 for liquids, 1.4 for gases, 1 the linear state
/// p = c^2 (rho - rho_0) + p_b. p_b [Pa] is the same in all phases: it drives nothing but keeps the interface band from tearing. Without
/// p_min [Pa] there is no least pressure; with 0 a fluid that is pulled parts, and a free surface is where the pressure ends.
/// Verified by test/unit/passes (hand values) and tutorials/verification/hydrostatic.
#pragma once
#include "Coefficients.hpp"
#include "fieldTags.hpp"

namespace sph
{

inline double unlessParted(double p, double p_min) { return std::fmax(p, std::fmin(0.0, 2*p_min - p)); }

struct Tait
{
    static constexpr auto name = "tait";
    using Provides = Pressure;
    using ReadsOwn = Fields<Density>;
    double restDensity, B, n, p_b, p_min;

    explicit Tait(const Coefficients& c)
        : restDensity(c.restDensity[0]), B(c.stiffness[0]), n(c.exponent[0]), p_b(c.backgroundPressure), p_min(c.leastPressure)
    {}
    auto operator()(const auto& i) const { return unlessParted(B*(std::pow(i.rho/restDensity, n) - 1) + p_b, p_min); }
};

/// The same, but for particles that an opening holds, whose pressure it gives.
struct TaitOrHeld : Tait
{
    static constexpr auto name = "taitOrHeld";
    using ReadsOwn = Fields<Density, Holder, HeldPressure>;
    using Tait::Tait;
    auto operator()(const auto& i) const { return i.holder > 0 ? i.p_h : Tait::operator()(i); }
};

/// The same with each phase's own constants.
struct TaitOfPhase
{
    static constexpr auto name = "taitOfPhase";
    using Provides = Pressure;
    using ReadsOwn = Fields<Density, Phase>;
    const double *restDensity, *B, *n;
    double p_b, p_min;

    explicit TaitOfPhase(const Coefficients& c)
        : restDensity(c.restDensity.data()), B(c.stiffness.data()), n(c.exponent.data()), p_b(c.backgroundPressure),
          p_min(c.leastPressure)
    {}
    auto operator()(const auto& i) const
    {
        const int k = int(i.phase);
        return unlessParted(B[k]*(std::pow(i.rho/restDensity[k], n[k]) - 1) + p_b, p_min);
    }
};

}
