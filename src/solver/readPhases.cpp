#include "solver/readPhases.hpp"
#include "base/words.hpp"
#include "case/phaseEntries.hpp"
#include "dictionary/positionExpression.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const VectorParameter bodyForce{"bodyForce", units::forcePerVolume, Vector<3>{}, "on all phases alike"};
const Scalar mu{"mu", units::viscosity, 0, nonNegative, "dynamic viscosity"},
    exponent{"exponent", units::none, 7, positive, "of Tait's equation of state"};
const AutomaticScalar soundSpeed{"soundSpeed", units::mPerS,
                                 byScene("automatic: 10 times the largest velocity that `expected` implies; with `gas none` less where the "
                                         "tension of the surface does not bear it, down to 3 times"),
                                 positive, "speed of sound, the same for all phases or not"};
const SubDictionary expected{"expected", byScene("needed for soundSpeed automatic"), "what the scene is expected to see"};
const Scalar depth{"depth", units::m, 0, nonNegative, "of the liquid: v = sqrt(g depth)"},
    radius{"radius", units::m, 0, nonNegative, "of curvature: v = sqrt(sigma/(rho radius))"},
    velocity{"velocity", units::mPerS, 0, nonNegative, "largest velocity"},
    pressure{"pressure", units::pressure, 0, nonNegative, "difference: v = sqrt(p/rho)"};
const FreeName dimensions{"dimensions", "list of numbers", "of value, as OpenFOAM has them; not looked at"};
}

namespace
{
/// The largest velocity that the scene is expected to see, and what sets it.
struct Expected
{
    double velocity = 0;
    std::string by;
    void consider(double v, const std::string& what)
    {
        if (v > velocity)
        {
            velocity = v;
            by = what;
        }
    }
};

Expected expectedVelocity(const Dictionary& dict, const Coefficients& c, double rho, double interfaceEnergy)
{
    Expected most;
    const auto expected = entry::expected(dict);
    const double depth = entry::depth(expected), radius = entry::radius(expected);
    most.consider(entry::velocity(expected), "the expected velocity");
    most.consider(std::sqrt(mag(c.g) * depth), "the hydrostatic pressure over the expected depth");
    most.consider(std::sqrt(entry::pressure(expected) / rho), "the expected pressure difference");
    if (radius > 0) most.consider(std::sqrt(interfaceEnergy / (rho * radius)), "the capillary pressure at the expected radius");
    return most;
}

/// The density at the free surface of a liquid alone is 1 % off (src/models/gas): rho c^2 as pressures of the surface, gamma/spacing, that it may be. The first is what an automatic sound speed takes, half of what bodies of few
/// spacings bear; at four times that their drips leave several times too fast, and jumps across curved surfaces are slow to settle.
constexpr double stiffnessOfLiquidAlone = 50, mostOfLiquidAlone = 200;

/// Sound speed over the largest velocity: densities within 1 % as the rule, and within a tenth where a free surface asks for a soft liquid.
constexpr double soundOverVelocity = 10, leastSoundOverVelocity = 3;

/// The speed at which rho c^2 is `pressures` times gamma/spacing, of a liquid alone with a tension.
std::optional<double> boundOfLiquidAlone(const Settings& settings, double rho, double pressures)
{
    const double interfaceEnergy = settings.facts.get<InterfaceEnergy>().largest;
    if (!settings.facts.get<GasLeftOut>().isLeftOut || !(interfaceEnergy > 0)) return {};
    return std::sqrt(pressures * interfaceEnergy / (rho * settings.coefficients.spacing));
}

void warnOfStiffLiquidAlone(const Case& theCase, const Dictionary& phase, const Settings& settings, double rho, double sound)
{
    const auto most = boundOfLiquidAlone(settings, rho, mostOfLiquidAlone),
               good = boundOfLiquidAlone(settings, rho, stiffnessOfLiquidAlone);
    if (!most || sound <= *most) return;
    theCase.diagnostics().warning(
        entry::soundSpeed.where(phase),
        fmt::format(
            "soundSpeed {:.4g} m/s makes rho c^2 {:.3g} times sigma/spacing, and without gas the density of a free surface is some 1 % off: "
            "drops of few spacings are driven by that, at many times their speed. Take three times the largest velocity, or {:.3g} m/s if that is more; "
            "`automatic` does so by what `expected` gives",
            sound, stiffnessOfLiquidAlone * sqr(sound / *good), *good));
}

/// The sound speed that `expected` implies, with its reason for the log; 0 where it implies none.
double automaticSoundSpeed(const Dictionary& dict, Settings& settings, const std::string& phase, double rho)
{
    const auto most = expectedVelocity(dict, settings.coefficients, rho, settings.facts.get<InterfaceEnergy>().largest);
    if (!(most.velocity > 0)) return 0;
    double sound = soundOverVelocity * most.velocity;
    std::string why;
    if (const auto bound = boundOfLiquidAlone(settings, rho, stiffnessOfLiquidAlone); bound && *bound < sound)
    {
        sound = std::max(*bound, leastSoundOverVelocity * most.velocity);
        why = fmt::format(
            ", in place of {:.3g}, since a free surface without gas bears some {:.3g} sigma/spacing of rho c^2, and these are {:.3g}",
            soundOverVelocity, stiffnessOfLiquidAlone, stiffnessOfLiquidAlone * sqr(sound / *bound));
    }
    settings.reasons.push_back(
        fmt::format("sound speed of {} {:.4g} m/s: {:.4g} x {:.4g} m/s by {}{}{}", phase, sound, sound / most.velocity, most.velocity,
                    most.by, why,
                    settings.shaking.empty() ? "" : "; `shaking` of constant/g is not in it: `expected` is to have what it does"));
    return sound;
}

/// Lengths from which no velocity follows.
void checkExpected(const Dictionary& dict, const Coefficients& c, double interfaceEnergy)
{
    const auto expected = entry::expected(dict);
    if (entry::depth.given(expected) && !(mag(c.g) > 0))
        entry::depth.error(expected, "depth does nothing without gravity, `value` of constant/g: give that, or leave depth out");
    if (entry::radius.given(expected) && !(interfaceEnergy > 0))
        entry::radius.error(expected, "radius does nothing without sigma between two phases: give that, or leave radius out");
}

std::string readShaking(const Dictionary& g, int dimension)
{
    const auto text = entry::shaking(g, "");
    if (text.empty()) return text;
    try
    {
        const auto value = evaluateAt(text, anyPlace, 0.0);
        if (value.vector) entry::shaking.checkPlane(g, *value.vector, dimension);
        else entry::shaking.error(g, fmt::format("\"{}\" gives a number: an acceleration is a vector, vector(x, y, z)", text));
        return text;
    }
    catch (const ExpressionError& e)
    {
        entry::shaking.error(g, e.what());
        return "";
    }
}
}

EntryList phaseEntries()
{
    using namespace entry;
    return {phases,
            {phaseName, {rho, mu, stress, soundSpeed, exponent}},
            bodyForce,
            {expected, {entry::velocity, depth, pressure, entry::radius}}};
}
EntryList gravityEntries() { return {entry::dimensions, entry::gravity, entry::shaking}; }

/// A phase whose rho c^2 a pressure exceeds changes its density by a third and more (Tait's law, n = 7). What `expected` implies are
/// pressures of the flow; those of a band of interface are there besides, however slow the flow.
void warnOfSoftPhases(const Case& theCase, const Settings& settings)
{
    const auto& c = settings.coefficients;
    if (!settings.facts.get<InterfaceForces>().act || settings.facts.get<GasLeftOut>().isLeftOut) return; // none has a band of interface
    const double capillary = settings.facts.get<InterfaceEnergy>().largest / c.spacing;
    const double most = std::abs(c.backgroundPressure) + capillary;
    for (std::size_t k = 0; k < c.phases.size(); ++k)
    {
        const double stiffness = c.restDensity[k] * sqr(c.soundSpeed[k]);
        const auto& where = settings.automaticSound[k];
        if (!where || !(stiffness < most)) continue;
        theCase.diagnostics().warning(
            *where,
            fmt::format(
                "the automatic sound speed of {}, {:.4g} m/s, makes rho c^2 {:.3g} Pa, less than the background pressure, {:.3g} Pa, and the capillary pressure "
                "sigma/spacing, {:.3g} Pa, together: its density will vary by a third and more. A soundSpeed of {:.3g} m/s keeps it within 1 %, one of {:.3g} "
                "m/s within 10 %",
                c.phases[k], c.soundSpeed[k], stiffness, c.backgroundPressure, capillary, 10 * std::sqrt(most / c.restDensity[k]),
                std::sqrt(10 * most / c.restDensity[k])));
    }
}

void readScene(const Case& theCase, const Dictionary& dict, Settings& settings)
{
    auto& c = settings.coefficients;
    c.phases = entry::phases(dict);
    if (entry::phases.given(dict) && c.phases.empty()) entry::phases.error(dict, "there must be at least one phase");
    if (theCase.has("constant/g"))
    {
        const auto g = theCase.dictionary("constant/g");
        g.ignore(entry::dimensions.keyword());
        c.g = entry::gravity(g);
        entry::gravity.checkPlane(g, c.g, c.dimension);
        settings.shaking = readShaking(g, c.dimension);
        g.reportUnused();
    }
    c.bodyForce = entry::bodyForce(dict);
    entry::bodyForce.checkPlane(dict, c.bodyForce, c.dimension);
}

void readPhases(const Case& theCase, const Dictionary& dict, Settings& settings)
{
    auto& c = settings.coefficients;
    const double interfaceEnergy = settings.facts.get<InterfaceEnergy>().largest;
    for (const auto& name : c.phases)
    {
        const auto phase = dict.subDict(name);
        const double rho = entry::rho(phase);
        settings.automaticSound.emplace_back();
        c.restDensity.push_back(rho);
        if (entry::stress(phase) == byLaw)
        {
            c.viscosity.push_back(0);
            c.soundSpeed.push_back(0);
            c.stateEquation.push_back(StateEquation::tait(rho, 0, 1));
            continue;
        }
        c.viscosity.push_back(entry::mu(phase));
        double sound = 1;
        if (const auto given = entry::soundSpeed(phase))
        {
            sound = *given;
            warnOfStiffLiquidAlone(theCase, phase, settings, rho, sound);
        }
        else
        {
            settings.automaticSound.back() = entry::soundSpeed.given(phase) ? entry::soundSpeed.where(phase) : phase.location();
            sound = automaticSoundSpeed(dict, settings, name, rho);
            if (!(sound > 0))
                entry::soundSpeed.error(
                    phase,
                    fmt::format(
                        "\"soundSpeed\" of {} is missing, and constant/phaseProperties has no `expected {{ velocity; depth; pressure; "
                        "radius; }}` to choose it from",
                        name));
        }
        c.soundSpeed.push_back(sound);
        c.stateEquation.push_back(StateEquation::tait(rho, sound, entry::exponent(phase)));
    }
    if (std::ranges::any_of(settings.automaticSound, [](const auto& where) { return where.has_value(); }))
        checkExpected(dict, c, interfaceEnergy);
    if (c.phases.empty()) // an error by now: a harmless one for what reads on
    {
        c.phases = {"fluid"};
        settings.automaticSound.resize(1);
        c.viscosity = {0};
        c.restDensity = c.soundSpeed = {1};
        c.stateEquation = {StateEquation::tait(1, 1, 1)};
    }
}

}
