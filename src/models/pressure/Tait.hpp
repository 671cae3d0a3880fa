/// State equation of Tait, per phase: eq. (7) ff. of Barker et al. (2012) after Becker & Teschner (2007).
///
///   p = q                          q >= p_min,    q = B ((rho/rho_0)^n - 1) + p_b,   B = rho_0 c^2/n
///     = min(0, 2 p_min - q)        q <  p_min
///
/// p [Pa], rho [kg/m^3], rho_0 rest density, c [m/s] sound speed at rest density; n = 7 for liquids, 1.4 for gases, 1 the linear state
/// p = c^2 (rho - rho_0) + p_b. p_b [Pa] is the same in all phases: it drives nothing but keeps the interface band from tearing. p_min <= 0 [Pa]
/// is the tension at which a fluid parts: beyond it what holds it together fades and at twice that is gone. A particle at a free surface,
/// whose volume by number density is too large by what is missing of its neighbours, so has no pressure, and the fluid behind it can be pulled:
/// with p_min = 0 a stretched liquid falls apart into strings (tutorials/powderMoulding/mould).
/// Verified by test/unit/plan (hand values) and tutorials/verification/hydrostatic.
#pragma once
#include "Coefficients.hpp"
#include "fieldTags.hpp"

namespace sph
{

/// Pressure from the q that the density gives: below p_min the liquid parts, and its tension fades to 0.
inline double unlessParted(double q, double p_min) { return std::fmax(q, std::fmin(0.0, 2 * p_min - q)); }

struct Tait
{
    static constexpr auto name = "tait";
    using Provides = Pressure;
    using ReadsOwn = Fields<Density>;
    double restDensity, B, n, p_b, p_min;

    explicit Tait(const Coefficients& c)
        : restDensity(c.restDensity[0]), B(c.stiffness[0]), n(c.exponent[0]), p_b(c.backgroundPressure), p_min(c.leastPressure)
    {}
    auto operator()(const auto& i) const { return unlessParted(B * (std::pow(i.rho / restDensity, n) - 1) + p_b, p_min); }
};

/// Tait's pressure, but for buffer particles, whose pressure the opening gives.
struct TaitOrHeld : Tait
{
    static constexpr auto name = "taitOrHeld";
    using ReadsOwn = Fields<Density, Holder, HeldPressure>;
    using Tait::Tait;
    auto operator()(const auto& i) const { return i.holder > 0 ? i.p_h : Tait::operator()(i); }
};

/// Tait's pressure with each phase's own constants.
struct TaitOfPhase
{
    static constexpr auto name = "taitOfPhase";
    using Provides = Pressure;
    using ReadsOwn = Fields<Density, Phase>;
    const double *restDensity, *B, *n;
    double p_b, p_min;

    explicit TaitOfPhase(const Coefficients& c)
        : restDensity(c.restDensity.data()), B(c.stiffness.data()), n(c.exponent.data()), p_b(c.backgroundPressure), p_min(c.leastPressure)
    {}
    auto operator()(const auto& i) const
    {
        const int k = int(i.phase);
        return unlessParted(B[k] * (std::pow(i.rho / restDensity[k], n[k]) - 1) + p_b, p_min);
    }
};

/// Tait's pressure with each phase's own constants, but for buffer particles.
struct TaitOfPhaseOrHeld : TaitOfPhase
{
    static constexpr auto name = "taitOfPhaseOrHeld";
    using ReadsOwn = Fields<Density, Phase, Holder, HeldPressure>;
    using TaitOfPhase::TaitOfPhase;
    auto operator()(const auto& i) const { return i.holder > 0 ? i.p_h : TaitOfPhase::operator()(i); }
};

}
