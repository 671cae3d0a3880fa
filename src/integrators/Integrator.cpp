#include "integrators/Integrator.hpp"
#include "dictionary/addDefaults.hpp"
#include "integrators/ImplicitSolve.hpp"
#include "scene/TwoLevels.hpp"
#include "scene/singlePrecision.hpp"
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
const Integrator& implicitIntegrator();
const Integrator& quasiSteadyIntegrator();
const Integrator& verletIntegrator();
/// Declares the increments of all fields that evolve (TwoLevels.hpp), and the steps that use them.
void readVerlet(Settings&);

const std::vector<const Integrator*>& integrators()
{
    static const std::vector<const Integrator*> all{
        &predictorCorrectorIntegrator(), &leapfrogIntegrator(),    &symplecticEulerIntegrator(), &semiImplicitIntegrator(),
        &implicitIntegrator(),           &quasiSteadyIntegrator(), &verletIntegrator()};
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
                    byScene("predictorCorrector; implicit where surface tension allows steps 1.5 times as long as all else does"),
                    "the integrator"};
const Count maxSubSteps{"maxSubSteps", 1, anyNumber,
                        "parts of a step at most, an odd number: surface tension acts in the middle one alone"},
    verletSteps{"verletSteps", 50, atLeast(2), "of verlet: each so many steps one starts from the present level alone"},
    maxIter{"maxIter", 1000, atLeast(1).saying("maxIter is a number of steps, at least 1, not {}"), "iterations of a solve at most"};
const Scalar theta{"theta", units::none, 1,
                   between(0.5, 1).saying("theta is 1/2 (Crank-Nicolson) to 1 (Euler), not {}: below 1/2 no step is stable however stiff"),
                   "where in the step the forces of a solve act: 1/2 (in the middle, of second order) to 1 (at the end, Euler)"},
    tolerance{"tolerance", units::none, byScene("1e-6; 0.1 with implicit"), positive,
              "residual of a solve over the velocity; with implicit over that at its start"},
    flowFactor{"flowFactor", units::none, 0.2, positive, "of the limit by flow, h/|v|, with implicit"},
    soundFactor{"soundFactor", units::none, byScene("0.4; half of it with verlet"), positive, "of the limit by sound, h/(c + |v|)"},
    dampedSoundFactor{"dampedSoundFactor", units::none, 0.25, positive, "of nu/c^2, where semiImplicit may step over sound"},
    stiffnessFactor{"stiffnessFactor", units::none, byScene("1.2; half of it with verlet"), positive,
                    "of the limit by the stiffness between phases"},
    viscousFactor{"viscousFactor", units::none, byScene("0.125; half of it with leapfrog, less with verlet, a third with viscosity cleary"),
                  positive, "of the limit by viscosity, h^2/nu"},
    diffusiveFactor{"diffusiveFactor", units::none, byScene("0.125; half of it with leapfrog, less with verlet"), positive,
                    "of the limit by diffusion of scalars, h^2/D"},
    capillaryFactor{"capillaryFactor", units::none, byScene("0.5; half of it with maxSubSteps, and with verlet"), positive,
                    "of the limit by surface tension"},
    forceFactor{"forceFactor", units::none, 0.25, positive, "of the limit by acceleration, sqrt(h/|dv/dt|)"},
    stepFactor{"stepFactor", units::none, 1, positive, "of all limits"};
}

namespace
{
/// The shares of stable steps that the case gives; those of limits that its scheme has not stay as they are, and are errors where they are given (checkStepFactors).
void readFactors(const Dictionary& dict, Integration& integration)
{
    auto& f = integration.factors;
    f.sound = entry::soundFactor(dict, f.sound);
    if (integration.solvesPressure) f.flow = entry::flowFactor(dict, f.flow);
    if (integration.solves && integration.moves && !integration.solvesPressure)
        f.dampedSound = entry::dampedSoundFactor(dict, f.dampedSound);
    f.stiffness = entry::stiffnessFactor(dict, f.stiffness);
    f.viscous = entry::viscousFactor(dict, f.viscous);
    f.diffusive = entry::diffusiveFactor(dict, f.diffusive);
    f.capillary = entry::capillaryFactor(dict, f.capillary);
    f.force = entry::forceFactor(dict, f.force);
    const double all = entry::stepFactor(dict);
    for (double* factor : {&f.sound, &f.flow, &f.dampedSound, &f.stiffness, &f.viscous, &f.diffusive, &f.capillary, &f.force})
        *factor *= all;
}

/// Surface tension allows steps of h^3/2, sound of h, and the stiffness of a liquid beside a light gas of a thirtieth of that: where it would allow half
/// as long a step again as all else, an implicit one pays, of some 25 sums over pairs beside the 14 of an explicit one (tutorials/stiff/dropOffLattice;
/// tutorials/verification/laplaceDrop, where it allows twice as long a step: 11 s beside 18 s).
std::string chosenScheme(const Reading& reading, const Dictionary& dict)
{
    auto& settings = reading.settings;
    const std::string explicitScheme = "predictorCorrector";
    const auto& facts = settings.facts;
    if (!facts.get<InterfaceForces>().act || reading.paper() || facts.get<IntegratedDensity>().exists ||
        !facts.get<PressureForce>().hasEnergy() || facts.get<OpenBoundary>().isDriven)
        return explicitScheme;
    constexpr double infinity = std::numeric_limits<double>::infinity(), worthSolving = 1.5;
    double slow = infinity;
    StepLimit least{infinity, "none"};
    auto byFactors = settings;
    readFactors(dict, byFactors.integration);
    for (const auto& limit : reading.limits(byFactors, {}))
        if (!limit.ofSubstep) slow = std::min(slow, limit.deltaT);
        else if (limit.deltaT < least.deltaT) least = limit;
    if (slow < worthSolving * least.deltaT) return explicitScheme;
    settings.reasons.push_back(fmt::format("integration implicit: surface tension allows steps of {:.3g} s, {} explicit ones of {:.3g} s",
                                           slow, least.by, least.deltaT));
    return "implicit";
}

void prepareTwoLevels(const Reading& reading, const Dictionary& dict)
{
    auto& settings = reading.settings;
    const TwoLevels levels(entry::verletSteps(dict));
    settings.coefficients.set(levels);
    auto& f = settings.integration.factors;
    for (double* factor : {&f.sound, &f.stiffness, &f.capillary})
        *factor *= 0.5; // what oscillates by omega is stable up to omega dt = 1, not 2
    for (double* factor : {&f.viscous, &f.diffusive}) *factor *= levels.stableDecay();
    if (settings.integration.maxSubSteps > 1)
        entry::maxSubSteps.error(dict, "goes with steps from one level: verlet's start a step before, take predictorCorrector or leapfrog");
    for (const auto& file : {settings.facts.by<OpenBoundary>(), settings.facts.by<VaryingViscosity>()})
        if (!file.empty())
            entry::scheme.error(dict,
                                fmt::format("verlet keeps two levels of all particles, and does not go with {}: take predictorCorrector "
                                            "or leapfrog",
                                            file));
}

void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& integration = settings.integration;
    const auto dict = entry::integration(reading.schemes);
    integration.scheme = entry::scheme.given(dict) ? entry::scheme.needed(dict) : chosenScheme(reading, dict);
    const auto& needs = integratorOf(integration.scheme).needs;
    integration.predicts = needs.predicts;
    integration.keepsRates = needs.keepsRates;
    integration.solves = needs.solves;
    integration.solvesPressure = needs.solvesPressure;
    integration.moves = needs.moves;
    if (needs.solves && needs.moves) integration.theta = entry::theta(dict);
    integration.factors.viscous *= needs.viscousFactor;
    integration.factors.diffusive *= needs.viscousFactor;
    integration.maxSubSteps = entry::maxSubSteps(dict);
    if (integration.maxSubSteps < 1 || integration.maxSubSteps % 2 == 0)
        entry::maxSubSteps.error(
            dict, "is an odd number, 1 or more: what acts once in a step does so in its middle, where all else is evaluated");
    if (needs.twoLevels) prepareTwoLevels(reading, dict);
    // Impulses that come less often than a quarter of the shortest capillary period shift what they balance (test/stability/README.md).
    if (integration.maxSubSteps > 1) integration.factors.capillary *= 0.5;
    if (integration.maxSubSteps > 1 && integration.solves)
        entry::maxSubSteps.error(
            dict,
            "goes with explicit integration: an implicit step is limited by surface tension alone, and with semiImplicit a drop was less exact by parts, and no faster");
    readFactors(dict, integration);
}

/// Least tolerance of a solve whose products see values in single precision, 6e-8 of them.
constexpr double leastOfSinglePrecision = 1e-6;

void readSolve(const Reading& reading, const Dictionary& dict)
{
    auto& settings = reading.settings;
    auto& integration = settings.integration;
    integration.tolerance = entry::tolerance(dict, integration.solvesPressure ? 0.1 : 1e-6);
    integration.maxIter = entry::maxIter(dict);
    if (integration.solvesPressure && integration.tolerance >= 1)
        entry::tolerance.error(dict, "is a share of the forces, below 1: at 1 nothing would be solved for");
    if (integration.solvesPressure)
        settings.reasons.push_back(
            fmt::format("pressure{} within the step (theta {:.3g}), by conjugate gradients to {:.3g} of the forces{}",
                        integration.viscosityAtStart ? "" : " and viscosity", integration.theta, integration.tolerance,
                        integration.viscosityAtStart ? "; viscosity, which does not shorten it, at its start" : ""));
    else if (integration.moves)
        settings.reasons.push_back(
            fmt::format("viscosity at the end of the step (theta {:.3g}), by conjugate gradients to {:.3g} of the velocity",
                        integration.theta, integration.tolerance));
    else
    {
        const bool carries = std::any_of(settings.state.begin(), settings.state.end(),
                                         [](const Evolving& q) { return q.rate && q.value.name != Velocity::info.name; });
        if (!carries)
            entry::scheme.error(dict,
                                "quasiSteady follows the migration of powder, or what diffuses, and there is no suspension and no scalar");
        if (reading.geometry.patches.empty())
            entry::scheme.error(dict, "quasiSteady needs walls: nothing else holds a flow without inertia");
        settings.reasons.push_back(
            fmt::format("particles at rest and velocities of creeping flow, by conjugate gradients to {:.3g}: time is that of the "
                        "powder's migration",
                        integration.tolerance));
    }
    if (integration.responses.empty()) return; // an error that viscosity reports
    settings.groups.push_back({.name = ofSolver,
                               .terms = integration.responses,
                               .changed = {VelocityChange::info.name},
                               .inputs = {VelocityChange::info.name},
                               .repeats = true,
                               .bearsSingle = integration.tolerance >= leastOfSinglePrecision &&
                                              singlePrecisionFails(settings.resolution.spacing, reading.geometry).empty()});
    if (integration.solvesPressure) settings.state.push_back({.value = stateField(DelayedImpulse{}), .advancedByModel = true});
    settings.runningModels.push_back(running<ImplicitSolve>());
}

void read(const Reading& reading)
{
    auto& integration = reading.settings.integration;
    const auto dict = entry::integration(reading.schemes);
    if (integration.solves) readSolve(reading, dict);
    if (reading.settings.coefficients.has<TwoLevels>()) readVerlet(reading.settings);
}

/// Whether a factor scales a limit of the step, for fluid at rest, slow or fast, thin or thick.
bool scalesALimit(const Reading& reading, double StepFactors::*factor)
{
    const auto& settings = reading.settings;
    const auto& ofParts = settings.integration.factorsOfRunningModels;
    if (std::ranges::find(ofParts, factor) != ofParts.end()) return true;
    auto halved = settings;
    halved.integration.factors.*factor *= 0.5;
    const auto& c = settings.coefficients;
    const double sound = *std::ranges::max_element(c.soundSpeed), mu = c.viscosity[0];
    for (const double speed : {0.0, 0.1 * sound, 10 * sound})
        for (const double thickness : {1.0, 1e3, 1e6})
        {
            Measured measured;
            measured.maxSpeed = speed;
            measured.maxAcceleration = measured.maxSlowAcceleration = 1;
            if (settings.facts.get<VaryingViscosity>().exists) measured.leastViscosity = measured.largestViscosity = thickness * mu;
            const auto isSame = [](const StepLimit& a, const StepLimit& b) { return a.by == b.by && a.deltaT == b.deltaT; };
            if (!std::ranges::equal(reading.limits(settings, measured), reading.limits(halved, measured), isSame)) return true;
        }
    return false;
}

/// s sqrt(h/|dv/dt|), s = 0.25
std::optional<StepLimit> forceLimit(const Settings& settings, const Measured& measured)
{
    if (!(measured.maxAcceleration > 0)) return {};
    const auto& integration = settings.integration;
    return StepLimit{integration.maxSubSteps *
                         (integration.factors.force * std::sqrt(0.5 * settings.coefficients.support / measured.maxAcceleration)),
                     "force", true, &Acceleration::info};
}
}

void checkStepFactors(const Reading& reading)
{
    const auto dict = entry::integration(reading.schemes);
    const std::pair<const Scalar&, double StepFactors::*> factors[]{
        {entry::soundFactor, &StepFactors::sound},         {entry::stiffnessFactor, &StepFactors::stiffness},
        {entry::viscousFactor, &StepFactors::viscous},     {entry::diffusiveFactor, &StepFactors::diffusive},
        {entry::capillaryFactor, &StepFactors::capillary}, {entry::forceFactor, &StepFactors::force},
        {entry::flowFactor, &StepFactors::flow},           {entry::dampedSoundFactor, &StepFactors::dampedSound}};
    for (const auto& [entry, factor] : factors)
        if (entry.given(dict) && !isDefault(dict, entry.keyword()) && !scalesALimit(reading, factor))
            entry.error(dict,
                        fmt::format("{} does nothing here: it is the share {}, and no step of this scene has that limit; leave it out",
                                    entry.keyword(), entry.info().meaning));
}

const Model& integrationModel()
{
    static const Model model{"integration",
                             "how time passes: the integrator, its solver, and the fractions of stable steps",
                             read,
                             {},
                             {},
                             prepare,
                             {},
                             {forceLimit},
                             {{"system/sphSchemes",
                               {{entry::integration,
                                 {entry::scheme, entry::maxSubSteps, entry::verletSteps, entry::theta, entry::tolerance, entry::maxIter,
                                  entry::stepFactor, entry::soundFactor, entry::flowFactor, entry::dampedSoundFactor,
                                  entry::stiffnessFactor, entry::viscousFactor, entry::diffusiveFactor, entry::capillaryFactor,
                                  entry::forceFactor}}}}}};
    return model;
}

}
