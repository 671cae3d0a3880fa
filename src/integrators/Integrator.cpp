#include "Integrator.hpp"
#include "ImplicitViscosity.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace sph
{

const Integrator& predictorCorrectorIntegrator();
const Integrator& leapfrogIntegrator();
const Integrator& symplecticEulerIntegrator();
const Integrator& semiImplicitIntegrator();
const Integrator& quasiSteadyIntegrator();

const std::vector<const Integrator*>& integrators()
{
    static const std::vector<const Integrator*> all{&predictorCorrectorIntegrator(), &leapfrogIntegrator(), &symplecticEulerIntegrator(),
                                                    &semiImplicitIntegrator(), &quasiSteadyIntegrator()};
    return all;
}

const Integrator& integratorOf(const std::string& word)
{
    for (const auto* each : integrators())
        if (each->word == word) return *each;
    throw std::logic_error("there is no integrator \"" + word + "\"");
}

static ChoiceWords integratorWords()
{
    ChoiceWords words;
    for (const auto* each : integrators()) words.emplace_back(each->word, each->meaning);
    return words;
}

namespace entry
{
const SubDictionary integration{"integration", notGiven, "how time passes"}; // of system/sphSchemes
const Choice scheme{"scheme", integratorWords(),
                    byScene("predictorCorrector; with surface tension symplecticEuler where it would allow steps 3 times as long as sound or the stiffness "
                            "between phases do, semiImplicit where viscosity asks for steps 6 times shorter still"),
                    "the integrator"};
const Count maxSubSteps{"maxSubSteps", byScene("81 where surface tension allows the longer steps; else 1"), anyNumber,
                        "parts of a step at most, an odd number: surface tension acts in the middle one alone"},
    maxIter{"maxIter", 1000, atLeast(1).saying("maxIter is a number of steps, at least 1, not {}"), "iterations of a solve at most"};
const Scalar theta{"theta", units::none, 1, positive, "of semiImplicit: 1/2 (Crank-Nicolson) to 1 (Euler)"},
    tolerance{"tolerance", units::none, 1e-6, positive, "residual of a solve over the velocity"},
    soundFactor{"soundFactor", units::none, 0.4, positive, "of the limit by sound, h/(c + |v|)"},
    dampedSoundFactor{"dampedSoundFactor", units::none, 0.25, positive, "of nu/c^2, where semiImplicit may step over sound"},
    stiffnessFactor{"stiffnessFactor", units::none, 1.2, positive, "of the limit by the stiffness between phases"},
    viscousFactor{"viscousFactor", units::none, byScene("0.125; half of it with leapfrog, a third with viscosity cleary"), positive, "of the limit by viscosity, h^2/nu"},
    diffusiveFactor{"diffusiveFactor", units::none, byScene("0.125; half of it with leapfrog"), positive, "of the limit by diffusion of scalars, h^2/D"},
    capillaryFactor{"capillaryFactor", units::none, byScene("0.5; half of it with maxSubSteps"), positive, "of the limit by surface tension"},
    forceFactor{"forceFactor", units::none, 0.25, positive, "of the limit by acceleration, sqrt(h/|dv/dt|)"},
    stepFactor{"stepFactor", units::none, 1, positive, "of all limits"};
}

namespace
{
/// Between phases with surface tension sound and stiffness bind long before surface tension does. Parts of a step cost two sums over pairs
/// each, an implicit step with its own surface tension and iterations about six times that (tutorials/stiff/dropOffLattice).
struct Chosen
{
    std::string scheme = "predictorCorrector";
    int maxSubSteps = 1;
};
Chosen chooseForTension(const Reading& reading)
{
    constexpr double infinity = std::numeric_limits<double>::infinity(), worthParts = 3, worthSolving = 6;
    constexpr int mostParts = 81; // surface tension is then a thirtieth of the work
    double once = infinity, ofPart = infinity, solvable = infinity;
    for (const auto& limit : reading.limits(reading.settings))
    {
        auto& least = limit.solvable ? solvable : limit.ofPart ? ofPart : once;
        least = std::min(least, limit.deltaT);
    }
    auto& reasons = reading.settings.reasons;
    if (worthSolving*solvable < std::min(once, ofPart))
    {
        reasons.push_back(fmt::format("integration semiImplicit: viscosity would limit the step to {:.3g} s, all else to {:.3g} s", solvable, std::min(once, ofPart)));
        return {"semiImplicit", 1};
    }
    ofPart = std::min(ofPart, solvable);
    if (worthParts*ofPart > once) return {};
    reasons.push_back(fmt::format("integration symplecticEuler with maxSubSteps {}: surface tension allows steps of {:.3g} s, all else {:.3g} s", mostParts, once, ofPart));
    return {"symplecticEuler", mostParts};
}

void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& integration = settings.integration;
    const auto dict = entry::integration(reading.schemes);
    const auto chosen = settings.surfaceTension && !reading.paper() && !entry::scheme.given(dict) && !entry::maxSubSteps.given(dict) ? chooseForTension(reading) : Chosen();
    integration.scheme = entry::scheme(dict, chosen.scheme);
    const auto& needs = integratorOf(integration.scheme).needs;
    integration.predicts = needs.predicts;
    integration.keepsRates = needs.keepsRates;
    integration.solves = needs.solves;
    integration.moves = needs.moves;
    integration.factors.viscous *= needs.viscousFactor;
    integration.factors.diffusive *= needs.viscousFactor;
    integration.maxSubSteps = entry::maxSubSteps(dict, chosen.maxSubSteps);
    if (integration.maxSubSteps < 1 || integration.maxSubSteps%2 == 0)
        entry::maxSubSteps.error(dict, "is an odd number, 1 or more: what acts once in a step does so in its middle, where all else is evaluated");
    // Impulses that come less often than a quarter of the shortest capillary period shift what they balance (test/stability/README.md).
    if (integration.maxSubSteps > 1) integration.factors.capillary *= 0.5;
    if (integration.maxSubSteps > 1 && integration.solves)
        entry::maxSubSteps.error(dict, "goes with explicit integration: with semiImplicit a drop was less exact by it, and no faster (src/integrators/README.md)");
}

void readSolve(const Reading& reading, const Dictionary& dict)
{
    auto& settings = reading.settings;
    auto& integration = settings.integration;
    integration.tolerance = entry::tolerance(dict);
    integration.maxIter = entry::maxIter(dict);
    if (integration.moves)
    {
        integration.theta = entry::theta(dict);
        if (integration.theta < 0.5 || integration.theta > 1)
            entry::theta.error(dict, "is 1/2 (Crank-Nicolson) to 1 (Euler): below 1/2 no step is stable however stiff");
        settings.reasons.push_back(fmt::format("viscosity at the end of the step (theta {:.3g}), by conjugate gradients to {:.3g} of the velocity",
                                               integration.theta, integration.tolerance));
    }
    else
    {
        const bool carries = std::any_of(settings.state.begin(), settings.state.end(),
                                         [](const Evolving& q) { return q.rate && q.value.name != Velocity::info.name; });
        if (!carries) entry::scheme.error(dict, "quasiSteady follows the migration of powder, or what diffuses, and there is no suspension and no scalar");
        if (reading.geometry.patches.empty()) entry::scheme.error(dict, "quasiSteady needs walls: nothing else holds a flow without inertia");
        settings.reasons.push_back(fmt::format("particles at rest and velocities of creeping flow, by conjugate gradients to {:.3g}: time is that of the "
                                               "powder's migration", integration.tolerance));
    }
    if (integration.response.empty()) return; // an error that viscosity reports
    reading.select(integration.responseRate);
    settings.groups.push_back({ofSolver, {integration.response}, {VelocityChange::info.name}, {}, {VelocityChange::info.name}});
    settings.parts.push_back(partOf<ImplicitViscosity>());
}

void read(const Reading& reading)
{
    auto& integration = reading.settings.integration;
    const auto dict = entry::integration(reading.schemes);
    auto& f = integration.factors;
    f.sound = entry::soundFactor(dict, f.sound);
    if (integration.solves && integration.moves) f.dampedSound = entry::dampedSoundFactor(dict, f.dampedSound);
    f.stiffness = entry::stiffnessFactor(dict, f.stiffness);
    f.viscous = entry::viscousFactor(dict, f.viscous);
    f.diffusive = entry::diffusiveFactor(dict, f.diffusive);
    f.capillary = entry::capillaryFactor(dict, f.capillary);
    f.force = entry::forceFactor(dict, f.force);
    const double all = entry::stepFactor(dict);
    for (double* factor : {&f.sound, &f.dampedSound, &f.stiffness, &f.viscous, &f.diffusive, &f.capillary, &f.force}) *factor *= all;
    if (integration.solves) readSolve(reading, dict);
}

/// s sqrt(h/|dv/dt|), s = 0.25
std::optional<StepLimit> forceLimit(const Settings& settings, const Measured& measured)
{
    if (!(measured.maxAcceleration > 0)) return {};
    const auto& integration = settings.integration;
    return StepLimit{integration.maxSubSteps*(integration.factors.force*std::sqrt(0.5*settings.coefficients.support/measured.maxAcceleration)), "force", true};
}
}

const Model& integrationModel()
{
    static const Model model{"integration", "how time passes: the integrator, its solver, and the fractions of stable steps", read, {}, {}, prepare,
                             {}, {forceLimit},
                             {{"system/sphSchemes",
                               {{entry::integration,
                                 {entry::scheme, entry::maxSubSteps, entry::theta, entry::tolerance, entry::maxIter, entry::stepFactor, entry::soundFactor,
                                  entry::dampedSoundFactor, entry::stiffnessFactor, entry::viscousFactor, entry::diffusiveFactor, entry::capillaryFactor, entry::forceFactor}}}}}};
    return model;
}

}
