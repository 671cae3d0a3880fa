#include "Integrator.hpp"
#include "ImplicitViscosity.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
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

namespace
{
int readCount(const Dictionary& dict, const char* key, int fallback)
{
    const int count = dict.get<int>(key, fallback);
    if (count < 1) dict.error(key, fmt::format("{} is a number of steps, at least 1, not {}", key, count));
    return count;
}

void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& integration = settings.integration;
    const auto dict = reading.schemes.subDictOrEmpty("integration");
    std::vector<std::string> words;
    for (const auto* each : integrators()) words.push_back(each->word);
    integration.scheme = dict.choose("scheme", words, words.front());
    const auto known = std::find(words.begin(), words.end(), integration.scheme);
    const auto& needs = integratorOf(known == words.end() ? words.front() : *known).needs;
    integration.predicts = needs.predicts;
    integration.keepsRates = needs.keepsRates;
    integration.solves = needs.solves;
    integration.moves = needs.moves;
    integration.factors.viscous *= needs.viscousFactor;
    integration.factors.diffusive *= needs.viscousFactor;
    integration.maxSubSteps = dict.get<int>("maxSubSteps", 1);
    if (integration.maxSubSteps < 1 || integration.maxSubSteps%2 == 0)
        dict.error("maxSubSteps", "is an odd number, 1 or more: what acts once in a step does so in its middle, where all else is evaluated");
    // Impulses that come less often than a quarter of the shortest capillary period shift what they balance (test/stability/README.md).
    if (integration.maxSubSteps > 1) integration.factors.capillary *= 0.5;
    if (integration.maxSubSteps > 1 && integration.solves)
        dict.error("maxSubSteps", "goes with explicit integration: with semiImplicit a drop was less exact by it, and no faster (src/integrators/README.md)");
}

void readSolve(const Reading& reading, const Dictionary& dict)
{
    auto& settings = reading.settings;
    auto& integration = settings.integration;
    integration.tolerance = dict.getPositive("tolerance", units::none, integration.tolerance);
    integration.maxIter = readCount(dict, "maxIter", integration.maxIter);
    if (integration.moves)
    {
        integration.theta = dict.getPositive("theta", units::none, integration.theta);
        if (integration.theta < 0.5 || integration.theta > 1)
            dict.error("theta", "is 1/2 (Crank-Nicolson) to 1 (Euler): below 1/2 no step is stable however stiff");
        settings.reasons.push_back(fmt::format("viscosity at the end of the step (theta {:.3g}), by conjugate gradients to {:.3g} of the velocity",
                                               integration.theta, integration.tolerance));
    }
    else
    {
        const bool carries = std::any_of(settings.state.begin(), settings.state.end(),
                                         [](const Evolving& q) { return q.rate && q.value.name != Velocity::info.name; });
        if (!carries) dict.error("scheme", "quasiSteady follows the migration of powder, or what diffuses, and there is no suspension and no scalar");
        if (reading.geometry.patches.empty()) dict.error("scheme", "quasiSteady needs walls: nothing else holds a flow without inertia");
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
    const auto dict = reading.schemes.subDictOrEmpty("integration");
    auto& f = integration.factors;
    f.sound = dict.getPositive("soundFactor", units::none, f.sound);
    if (integration.solves && integration.moves) f.dampedSound = dict.getPositive("dampedSoundFactor", units::none, f.dampedSound);
    f.stiffness = dict.getPositive("stiffnessFactor", units::none, f.stiffness);
    f.viscous = dict.getPositive("viscousFactor", units::none, f.viscous);
    f.diffusive = dict.getPositive("diffusiveFactor", units::none, f.diffusive);
    f.capillary = dict.getPositive("capillaryFactor", units::none, f.capillary);
    f.force = dict.getPositive("forceFactor", units::none, f.force);
    const double all = dict.getPositive("stepFactor", units::none, 1);
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
                             {}, {forceLimit}};
    return model;
}

}
