/// The pressure of a particle: the equation of state of its phase (StateEquation.hpp), with the background and the tension at which a fluid parts.
///
///   p = q                          q >= p_min,    q = p(rho) + p_b
///     = min(0, 2 p_min - q)        q <  p_min
///
/// p [Pa]. p_b [Pa] is the same in all phases: it drives nothing but keeps the interface band from tearing. p_min <= 0 [Pa]
/// is the tension at which a fluid parts: beyond it what holds it together fades and at twice that is gone. A particle at a free surface,
/// whose volume by number density is too large by what is missing of its neighbours, so has no pressure, and the fluid behind it can be pulled:
/// with p_min = 0 a stretched liquid falls apart into strings (tutorials/powderMoulding/mould).
/// Verified by test/unit/plan (hand values) and tutorials/verification/hydrostatic.
#pragma once
#include "fields/fieldTags.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

/// Pressure from the q that the density gives: below p_min the liquid parts, and its tension fades to 0.
inline double unlessParted(double q, double p_min) { return std::fmax(q, std::fmin(0.0, 2 * p_min - q)); }

struct Tait
{
    static constexpr auto name = "tait";
    using Provides = Pressure;
    using ReadsOwn = Fields<Density>;
    StateEquation equation;
    double p_b, p_min;

    explicit Tait(const Coefficients& c) : equation(c.stateEquation[0]), p_b(c.backgroundPressure), p_min(c.leastPressure) {}
    auto operator()(const auto& i) const { return unlessParted(equation.pressure(i.rho) + p_b, p_min); }
};

/// Whether an opening holds the particle and gives its pressure.
inline bool isPrescribed(const auto& i) { return i.holder > 0 && i.p_h > HeldPressure::ofDensity; }

/// Tait's pressure, but for buffer particles whose pressure the opening gives.
struct TaitOrHeld : Tait
{
    static constexpr auto name = "taitOrHeld";
    using ReadsOwn = Fields<Density, Holder, HeldPressure>;
    using Tait::Tait;
    auto operator()(const auto& i) const { return isPrescribed(i) ? i.p_h : Tait::operator()(i); }
};

/// Tait's pressure with each phase's own constants.
struct TaitOfPhase
{
    static constexpr auto name = "taitOfPhase";
    using Provides = Pressure;
    using ReadsOwn = Fields<Density, Phase>;
    const StateEquation* equation;
    double p_b, p_min;

    explicit TaitOfPhase(const Coefficients& c) : equation(c.stateEquation.data()), p_b(c.backgroundPressure), p_min(c.leastPressure) {}
    auto operator()(const auto& i) const { return unlessParted(equation[int(i.phase)].pressure(i.rho) + p_b, p_min); }
};

/// Tait's pressure with each phase's own constants, but for buffer particles.
struct TaitOfPhaseOrHeld : TaitOfPhase
{
    static constexpr auto name = "taitOfPhaseOrHeld";
    using ReadsOwn = Fields<Density, Phase, Holder, HeldPressure>;
    using TaitOfPhase::TaitOfPhase;
    auto operator()(const auto& i) const { return isPrescribed(i) ? i.p_h : TaitOfPhase::operator()(i); }
};

}
