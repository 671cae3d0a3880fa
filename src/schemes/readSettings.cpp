#include "Kernel.hpp"
#include "Settings.hpp"
#include "readPhases.hpp"
#include "readTransport.hpp"
#include "wallLayers.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{
using Words = std::vector<std::string>;

/// The words of a scheme, with the defaults that measurements favour; `scheme paper;` sets those of Barker et al. (2012) instead.
struct Choices
{
    std::string density, volume, pressure, viscosity, tension, contactAngle, wall, wallPressure, normalisation, surfaceShifting, diffusion;
    std::string transportPressure;
};

Choices choose(const Dictionary& dict, const Settings& settings, const Geometry& geometry)
{
    const bool walls = !geometry.patches.empty();
    const Words schemes{"suite", "paper"};
    const bool paper = dict.choose("scheme", schemes, "suite") == "paper";
    const auto& c = settings.coefficients;
    const bool tension = std::any_of(c.surfaceTension.begin(), c.surfaceTension.end(), [](double s) { return s > 0; });
    const bool viscous = std::any_of(c.viscosity.begin(), c.viscosity.end(), [](double mu) { return mu > 0; });
    const bool second = !paper && walls && viscous && !settings.variableViscosity();
    Choices choice;
    choice.density = dict.choose("density", Words{"numberDensity", "continuity"}, "numberDensity");
    const bool integrated = choice.density == "continuity";
    choice.volume = dict.choose("volume", Words{"numberDensity", "continuity"}, choice.density);
    if (!integrated && choice.volume == "continuity") dict.error("volume", "goes with `density continuity;`: no density is integrated");
    // Between two phases the curvature form is the more exact and the calmer (tutorials laplaceDrop, contactAngle, bccBed); it goes with
    // the density-weighted pressure and the wall potential. More phases have the stress form alone, and so have the walls' stresses.
    const bool stress = paper || c.phases.size() > 2 || dict.isWord("contactAngle", "paper") || dict.isWord("contactAngle", "wallStress");
    const auto tensionDefault = !tension ? "none" : stress ? "interfaceStress" : "curvature";
    choice.tension = dict.choose("surfaceTension", Words{"interfaceStress", "curvature", "none"}, tensionDefault);
    const bool byCurvature = choice.tension == "curvature", byStress = choice.tension == "interfaceStress";
    const Words pressures{"huAdams", "densityWeighted", "monaghan", "difference", "correctedDifference", "tensileControlled"};
    choice.pressure = dict.choose("pressureGradient", pressures, byCurvature ? "densityWeighted" : "huAdams");
    choice.viscosity = dict.choose("viscosity", Words{"harmonic", "cleary", "none"}, viscous ? "harmonic" : "none");
    choice.contactAngle = dict.choose("contactAngle", Words{"wallStress", "wallPotential", "wallAdhesion", "paper"},
                                      byCurvature ? "wallPotential" : paper && byStress ? "paper" : "wallStress");
    choice.wall = dict.choose("wallVelocity", Words{"secondOrder", "reflected", "freeSlip"}, second ? "secondOrder" : "reflected");
    if (settings.wallLayers && choice.wall == "freeSlip")
        dict.error("wallVelocity", "freeSlip needs ghosts that carry the velocity along the wall from place to place; take walls reflected");
    choice.wallPressure = dict.choose("wallPressure", Words{"hydrostatic", "detaching", "mirrored"}, paper ? "mirrored" : "hydrostatic");
    choice.normalisation = dict.choose("normalisation", Words{"secondMoment", "none"},
                                       paper || choice.volume == "continuity" ? "none" : "secondMoment");
    choice.diffusion = dict.choose("densityDiffusionForm", Words{"molteni", "antuono"}, "molteni");
    choice.surfaceShifting = dict.choose("shiftingAtSurface", Words{"any", "tangential"}, "any");
    choice.transportPressure = dict.choose("transportPressure", Words{"uniform", "local"}, "uniform");
    const auto belongs = [&](const char* word, const char* to)
    {
        if (dict.found(word) && !dict.found(to))
            dict.error(word, fmt::format("does nothing without {}; give that a value, or leave this out", to));
    };
    belongs("densityDiffusionForm", "densityDiffusion");
    belongs("shiftingAtSurface", "shifting");
    belongs("shiftingSpeed", "shifting");
    belongs("transportPressure", "transportVelocity");
    if (c.transportVelocity > 0 && settings.shifting > 0)
        dict.error("transportVelocity", "keeps particles evenly spaced, and so does shifting: take one of them");
    if (settings.shifting > 0 && settings.integrator == Integrator::quasiSteady)
        dict.error("shifting", "moves particles, which quasiSteady leaves where they are: take 0, or integration scheme semiImplicit");
    if (c.transportVelocity > 0 && settings.solvesForVelocity())
        dict.error("transportVelocity", "goes with steps that sound limits; semiImplicit may take longer ones, in which particles are thrown apart");
    if (choice.wall == "secondOrder" && (settings.variableViscosity() || !viscous || choice.pressure != "huAdams"))
        dict.error("wallVelocity", "secondOrder needs a single phase of uniform viscosity and pressureGradient huAdams; take reflected");
    if (settings.wallLayers && choice.tension != "none")
        dict.error("walls", "layers have no interface to continue: with surface tension take walls reflected");
    if (choice.tension != "none" && !tension) dict.error("surfaceTension", "constant/phaseProperties gives no sigma between any two phases");
    if (choice.contactAngle == "paper" && choice.tension != "interfaceStress")
        dict.error("contactAngle", fmt::format("paper makes the solid a phase of the interface stress and goes with surfaceTension interfaceStress, not "
                                               "{}; take wallStress or wallPotential", choice.tension));
    if (choice.contactAngle == "wallAdhesion" && byStress)
        dict.error("contactAngle", "wallAdhesion turns the normals of surfaceTension curvature, and interfaceStress has none; take wallStress or wallPotential");
    if (dict.found("contactAngle") && (choice.tension == "none" || !geometry.wets()))
        dict.error("contactAngle", fmt::format("does nothing without {}; give that, or leave this out",
                                               geometry.wets() ? "surface tension between two phases" : "a wall that has a contactAngle in constant/geometry"));
    if (choice.viscosity == "none" && settings.suspension())
        dict.error("viscosity", "none leaves out the viscosity that powder migrates by; take harmonic or cleary");
    if (choice.viscosity == "none" && settings.solvesForVelocity())
        dict.error("integration", "semiImplicit and quasiSteady solve for viscosity, and there is none");
    if (integrated && !settings.predicts())
        dict.error("density", "continuity needs velocities of the middle of a step, or sound grows; take integration scheme leapfrog or predictorCorrector");
    if (choice.tension == "curvature" && c.phases.size() != 2) dict.error("surfaceTension", "curvature is between two phases; take interfaceStress");
    return choice;
}

Words termsOf(const Choices& choice, Settings& settings)
{
    const bool multiphase = settings.multiphase(), variable = settings.variableViscosity();
    Words terms;
    const auto add = [&](const std::string& name) { terms.push_back(name); };
    add(choice.volume == "continuity" ? "integratedVolume" : "numberDensity");
    add(choice.density == "continuity" ? "continuity" : "summedDensity");
    add(multiphase ? "taitOfPhase" : settings.openings.empty() ? "tait" : "taitOrHeld");
    if (choice.wall == "secondOrder") { add("separateHuAdamsPressure"); add("addPressure"); }
    else add(choice.pressure + "Pressure");
    if (choice.viscosity == "harmonic") add(variable ? "harmonicViscosity" : "singlePhaseViscosity");
    if (choice.viscosity == "cleary") add(variable ? "clearyViscosity" : "singlePhaseClearyViscosity");
    if (settings.solvesForVelocity())
    {
        const std::string form = choice.viscosity == "cleary" ? variable ? "cleary" : "singlePhaseCleary"
                                                              : variable ? "harmonicViscous" : "singlePhaseViscous";
        settings.implicitSolve.response = form + "Response";
        add(form + "Rate");
    }
    if (choice.normalisation == "secondMoment") add("gradientNormalisation");
    const bool angles = !settings.coefficients.wallTension.empty(), wetting = angles && choice.contactAngle == "wallStress";
    if (angles && choice.contactAngle == "paper") { add("solidPhaseStress"); add("stressOfSolid"); }
    else if (choice.tension == "interfaceStress") add("interfaceStress");
    if (wetting) add("wallTension");
    if (choice.tension == "interfaceStress" || wetting)
        add(choice.pressure == "densityWeighted" ? "densityWeightedStressDivergence" : "stressDivergence");
    if (choice.tension == "curvature")
    {
        add("curvatureForce");
        add(angles && choice.contactAngle == "wallAdhesion" ? "adheringColourGradient" : "smoothedColourGradient");
    }
    const auto& c = settings.coefficients;
    if (c.artificialViscosity > 0) add("artificialViscosity");
    if (mag(c.g) > 0) add("gravity");
    if (mag(c.bodyForce) > 0) add("bodyForce");
    if (settings.shifting > 0) add(choice.surfaceShifting == "tangential" ? "surfaceShifting" : "particleShifting");
    if (c.transportVelocity > 0)
    {
        add(choice.transportPressure == "local" ? "localTransportVelocity" : "transportVelocity");
        add("transportStress");
    }
    if (c.diffusion > 0) add(choice.diffusion == "antuono" ? "renormalisedDiffusion" : "densityDiffusion");
    return terms;
}

/// What acts once in a step of several parts becomes a list of its own: surface tension, whose curvature is four of the six sums over pairs
/// of a two-phase step. Viscosity shares its sum with the pressure: nothing would be gained.
void partSlowTerms(const Dictionary& integration, Settings& settings)
{
    if (settings.solvesForVelocity())
        integration.error("maxSubSteps", "goes with explicit integration: with semiImplicit a drop was less exact by it, and no faster "
                                         "(src/schemes/README.md)");
    static const Words capillary{"curvatureForce",   "smoothedColourGradient", "adheringColourGradient", "interfaceStress",
                                 "solidPhaseStress", "stressOfSolid",          "wallTension",            "stressDivergence",
                                 "densityWeightedStressDivergence"};
    const auto slow = std::stable_partition(settings.terms.begin(), settings.terms.end(), [&](const auto& term)
                                            { return std::find(capillary.begin(), capillary.end(), term) == capillary.end(); });
    settings.slowTerms.assign(slow, settings.terms.end());
    settings.terms.erase(slow, settings.terms.end());
    if (settings.slowTerms.empty()) return integration.error("maxSubSteps", "without surface tension nothing acts more slowly than sound");
    settings.reasons.push_back(fmt::format("up to {} parts to a step: surface tension acts in the middle one alone, all else in each",
                                           settings.maxSubSteps));
}

/// How powder migrates: words of their own, which only a suspension has.
void readMigration(const Dictionary& dict, Settings& settings)
{
    const bool paper = dict.isWord("scheme", "paper");
    auto& suspension = *settings.coefficients.suspension;
    const auto rate = dict.choose("shearRate", Words{"stress", "correctedGradient", "gradient"}, paper ? "gradient" : "stress");
    settings.correctedShear = rate != "gradient";
    auto& terms = settings.migrationTerms;
    if (rate == "stress")
    {
        suspension.subParticleShear = dict.getNonNegative("subParticleShear", units::none, 0.025);
        terms.push_back(suspension.subParticleShear > 0 ? "subParticleShear" : "resolvedShear");
    }
    else terms.push_back(rate == "gradient" ? "velocityGradientShear" : "correctedGradientShear");
    terms.push_back("phillipsFlux");
}

int readCount(const Dictionary& dict, const char* key, int fallback)
{
    const int count = dict.get<int>(key, fallback);
    if (count < 1) dict.error(key, fmt::format("{} is a number of steps, at least 1, not {}", key, count));
    return count;
}

void readIntegration(const Dictionary& schemes, Settings& settings)
{
    const auto dict = schemes.subDictOrEmpty("integration");
    const Words names{"predictorCorrector", "leapfrog", "symplecticEuler", "semiImplicit", "quasiSteady"};
    const auto name = dict.choose("scheme", names, "predictorCorrector");
    settings.integrator = Integrator(std::find(names.begin(), names.end(), name) - names.begin());
    auto& solve = settings.implicitSolve;
    if (settings.solvesForVelocity())
    {
        solve.tolerance = dict.getPositive("tolerance", units::none, solve.tolerance);
        solve.maxIter = readCount(dict, "maxIter", solve.maxIter);
    }
    if (settings.integrator == Integrator::semiImplicit)
    {
        solve.theta = dict.getPositive("theta", units::none, solve.theta);
        if (solve.theta < 0.5 || solve.theta > 1) dict.error("theta", "is 1/2 (Crank-Nicolson) to 1 (Euler): below 1/2 no step is stable however stiff");
        settings.reasons.push_back(fmt::format("viscosity at the end of the step (theta {:.3g}), by conjugate gradients to {:.3g} of the velocity",
                                               solve.theta, solve.tolerance));
    }
    settings.maxSubSteps = dict.get<int>("maxSubSteps", 1);
    if (settings.maxSubSteps < 1 || settings.maxSubSteps%2 == 0)
        dict.error("maxSubSteps", "is an odd number, 1 or more: what acts once in a step does so in its middle, where all else is evaluated");
    if (settings.integrator == Integrator::quasiSteady)
    {
        if (!settings.suspension()) dict.error("scheme", "quasiSteady follows the migration of powder, and there is no suspension");
        settings.reasons.push_back(fmt::format("particles at rest and velocities of creeping flow, by conjugate gradients to {:.3g}: time is that of the "
                                               "powder's migration", solve.tolerance));
    }
    auto& f = settings.factors;
    // The extrapolated velocity of leapfrog halves the viscous limit (Adams-Bashforth against mid-point).
    if (settings.integrator == Integrator::leapfrog) f.viscous *= 0.5;
    // Impulses that come less often than a quarter of the shortest capillary period shift what they balance (test/stability/README.md).
    if (settings.maxSubSteps > 1) f.capillary *= 0.5;
    // Along the line of centres compression is resisted by 3 mu: nu (laplacian v + 2 grad div v).
    if (schemes.isWord("viscosity", "cleary")) f.viscous /= 3;
    const auto damping = dict.subDictOrEmpty("damping");
    settings.dampingRate = damping.getNonNegative("rate", units::none/units::s, 0);
    settings.dampedUntil = damping.getNonNegative("until", units::s, 0);
    f.sound = dict.getPositive("soundFactor", units::none, f.sound);
    if (settings.integrator == Integrator::semiImplicit) f.dampedSound = dict.getPositive("dampedSoundFactor", units::none, f.dampedSound);
    f.stiffness = dict.getPositive("stiffnessFactor", units::none, f.stiffness);
    f.viscous = dict.getPositive("viscousFactor", units::none, f.viscous);
    f.capillary = dict.getPositive("capillaryFactor", units::none, f.capillary);
    f.force = dict.getPositive("forceFactor", units::none, f.force);
    if (settings.suspension())
    {
        f.migration = dict.getPositive("migrationFactor", units::none, f.migration);
        settings.migrationSteps = readCount(dict, "migrationSteps", settings.migrationSteps);
    }
    const double all = dict.getPositive("stepFactor", units::none, 1);
    for (double* factor : {&f.sound, &f.dampedSound, &f.stiffness, &f.viscous, &f.capillary, &f.force, &f.migration}) *factor *= all;
}
}

Resolution readResolution(const Dictionary& sphSchemes)
{
    const auto dict = sphSchemes.subDict("resolution");
    Resolution r;
    r.spacing = dict.getPositive("spacing", units::m);
    r.support = dict.getPositive("support", units::none, r.support);
    r.kernel = dict.choose("kernel", kernelNames(), r.kernel);
    if (r.support < 1.5 || r.support > 6) dict.error("support", "the kernel support is given in spacings and lies between 1.5 and 6");
    return r;
}

Settings readSettings(const Case& theCase, const Geometry& geometry)
{
    Settings settings;
    auto& c = settings.coefficients;
    const auto dict = theCase.dictionary("system/sphSchemes");
    settings.resolution = readResolution(dict);
    c.dimension = geometry.dimension;
    c.spacing = settings.resolution.spacing;
    c.support = settings.resolution.H();
    settings.wallLayers = wallsAreLayers(dict);
    if (settings.wallLayers && geometry.patches.empty()) dict.error("walls", "there are none in constant/geometry");
    if (!geometry.layers.empty())
        settings.reasons.push_back(fmt::format("walls of {} particles in layers, whose velocity continues the fluid's beyond the surface; nothing is mirrored",
                                               geometry.layers.size()));
    readPhases(theCase, settings);
    setContactAngles(geometry, settings);
    readTransport(theCase, settings);
    readIntegration(dict, settings);
    settings.leaked = readLeakGuard(dict);
    if (settings.suspension()) readMigration(dict, settings);
    settings.openings = readOpenings(theCase, geometry, c);
    for (const auto& opening : settings.openings)
        if (settings.multiphase() || settings.integrator == Integrator::quasiSteady)
            theCase.diagnostics().error(opening.where, fmt::format("opening \"{}\" needs {}", opening.name, settings.multiphase()
                                        ? "a scene of one phase: which phase comes in, and how phases leave together, is not settled"
                                        : "particles that move, which integration scheme quasiSteady leaves where they are; take semiImplicit"));
    if (dict.found("pMin")) c.leastPressure = dict.get("pMin", units::pressure);
    if (c.leastPressure > 0) dict.error("pMin", fmt::format("is the tension at which the fluid parts, 0 or less, not {:.4g} Pa", c.leastPressure));
    if (settings.integrator == Integrator::quasiSteady && geometry.patches.empty())
        dict.subDict("integration").error("scheme", "quasiSteady needs walls: nothing else holds a flow without inertia");

    settings.shifting = dict.getNonNegative("shifting", units::none, 0);
    settings.shiftsByLargestSpeed = dict.choose("shiftingSpeed", Words{"own", "largest"}, "own") == "largest";
    c.transportVelocity = dict.getNonNegative("transportVelocity", units::none, 0);
    c.artificialViscosity = dict.getNonNegative("artificialViscosity", units::none, 0);
    c.diffusion = dict.getNonNegative("densityDiffusion", units::none, 0);
    const auto choice = choose(dict, settings, geometry);
    settings.integratedDensity = choice.density == "continuity";
    for (int k = 0; k < geometry.dimension; ++k)
        if (geometry.periodic[k] && geometry.length(k) < c.support + c.spacing)
            dict.error("resolution", fmt::format("the domain's periodic length {:.4g} m along {} is less than the kernel support and a spacing, {:.4g} m",
                                                 geometry.length(k), "xyz"[k], c.support + c.spacing));
    if (c.diffusion > 0 && !settings.integratedDensity) dict.error("densityDiffusion", "goes with `density continuity;` alone");
    if (c.diffusion > 0 && settings.multiphase())
        for (double rho : c.restDensity)
            if (rho != c.restDensity[0]) { dict.error("densityDiffusion", "phases of different rest density cannot diffuse into one another"); break; }
    settings.normaliseDensity = choice.volume == "numberDensity" && choice.normalisation == "secondMoment";
    settings.stiffnessLimit = settings.multiphase() && choice.pressure != "densityWeighted";
    settings.wallVelocity = choice.wall == "secondOrder" ? WallVelocity::secondOrder
                          : choice.wall == "freeSlip"    ? WallVelocity::freeSlip
                                                         : WallVelocity::reflected;
    settings.hydrostaticGhosts = choice.wallPressure != "mirrored" && !geometry.patches.empty() && (mag(c.g) > 0 || mag(c.bodyForce) > 0);
    settings.detachingGhosts = settings.hydrostaticGhosts && choice.wallPressure == "detaching";
    settings.weighted = std::any_of(geometry.patches.begin(), geometry.patches.end(), [](const Patch& p)
                                    { return p.shape->smallestRadius() < std::numeric_limits<double>::infinity() || p.shape->hasEdges(); });
    settings.surfaceTension = choice.tension != "none";
    if (!settings.surfaceTension) c.wallTension.clear();
    settings.wallPotential = choice.contactAngle == "wallPotential" && !c.wallTension.empty();
    if (settings.wallPotential) settings.reasons.push_back("contact angles by the potential of the walls, added to dU/dt after the passes");
    // A solid of 90 degrees has no tension, but it is no fluid either: the fluids' colour gradients end at it.
    if (choice.contactAngle == "paper" && choice.tension == "interfaceStress" && geometry.wets())
    {
        c.wallTension.resize(geometry.walls.size()*c.phases.size());
        settings.reasons.push_back("contact angles by the solid as a phase of its own, as in the paper");
    }
    settings.terms = termsOf(choice, settings);
    if (settings.maxSubSteps > 1) partSlowTerms(dict.subDictOrEmpty("integration"), settings);

    double gamma = 0;
    for (double s : c.surfaceTension) gamma = std::max(gamma, s);
    const bool automatic = dict.isWord("backgroundPressure", "automatic") || !dict.found("backgroundPressure");
    if (!automatic) c.backgroundPressure = dict.get("backgroundPressure", units::pressure, 0);
    else if (settings.surfaceTension)
    {
        c.backgroundPressure = 0.8*gamma/c.spacing;
        settings.reasons.push_back(fmt::format("background pressure {:.4g} Pa: 0.8 gamma/spacing, so that the tension of the interface band does not "
                                               "tear the particles apart", c.backgroundPressure));
    }
    dict.reportUnused();
    return settings;
}

}
