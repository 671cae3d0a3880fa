#include "models/tension/tension.hpp"
#include "case/phaseEntries.hpp"
#include "models/tension/FreeBodies.hpp"
#include "models/tension/FreeSurfaceArea.hpp"
#include "models/tension/FreeSurfaceCurvature.hpp"
#include "models/tension/InterfaceArea.hpp"
#include "models/tension/Tensions.hpp"
#include "models/tension/WallTension.hpp"
#include "models/tension/WallWetting.hpp"
#include "models/tension/WettingAngles.hpp"
#include "models/tension/YoungsLaw.hpp"
#include "models/tension/depthBias.hpp"
#include "models/tension/phaseCurvatureTerms.hpp"
#include "models/tension/readTensions.hpp"
#include "models/tension/sigmaEntry.hpp"
#include "models/tension/tensionTerms.hpp"
#include "models/tension/wettingLaws.hpp"
#include "operators/operatorTerms.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <set>

namespace sph
{

namespace entry
{
const Choice surfaceTension{
    "surfaceTension",
    {{"interfaceStress", "divergence of Hu and Adams' stress, any number of phases"}, {"curvature", "of each interface"}, "none"},
    byScene(
        "curvature; interfaceStress with scheme paper, contactAngle wallStress, or more than three phases whose sigmas are no sums of a share of each; none "
        "without sigma"),
    "form of the surface tension"},
    contactAngle{"contactAngle",
                 {{"wallStress", "tension of the wall, with interfaceStress"},
                  {"wallPotential", "energy of the wall, with curvature"},
                  {"wallAdhesion", "direction of the interface, with curvature: lines of contact that move"},
                  {"paper", "the solid as a phase, with interfaceStress"}},
                 byScene("wallPotential with curvature; wallStress, or paper with scheme paper, with interfaceStress"),
                 "how walls hold their contact angle"};
}

namespace
{
bool isLiquidAlone(const Settings& settings) { return settings.facts.get<GasLeftOut>().isLeftOut; }

void declare(const Reading& reading)
{
    auto& c = reading.settings.coefficients;
    const bool alone = isLiquidAlone(reading.settings);
    Tensions tensions{alone ? readSurfaceTension(reading.phases, c) : readTensions(reading.phases, c), {}};
    if (const auto phase = reading.phases.subDictOrEmpty(c.phases.size() == 1 ? c.phases[0] : "");
        !alone && entry::sigmaOfSurface.given(phase))
        entry::sigmaOfSurface.error(
            phase, "of a phase is that of its free surface, with `gas none;` of system/sphSchemes: give that, or leave this out");
    reading.settings.facts.give(InterfaceEnergy{tensions.largest()}, "sigma of constant/phaseProperties");
    c.constants["sigma"] = tensions.between;
    c.set(std::move(tensions));
}

/// The largest contact angle of a liquid alone [degrees]: a half ball comes to rest at 122 for 120, and leaves a wall of 150.
constexpr double largestAngle = 120;

/// An angle is one of an interface that has a tension.
void refuseAngles(const Reading& reading, const std::string& why)
{
    std::set<std::string> said;
    for (const auto& wall : reading.geometry.walls)
        if (wall.wets && said.insert(toString(wall.anglesAt)).second)
            reading.theCase.diagnostics().error(wall.anglesAt,
                                                fmt::format("the contact angle of wall \"{}\" does nothing here: {}", wall.name, why));
}

/// The angles at which walls hold a free surface.
void setAnglesOfLiquidAlone(const Reading& reading, Coefficients& c)
{
    WettingAngles angles;
    bool neutral = true;
    for (const auto& wall : reading.geometry.walls)
    {
        const double angle = wall.wets ? wall.contactAngle : 90;
        neutral = neutral && angle == 90;
        angles.cosine.push_back(angle == 90 ? 0 : std::cos(angle * std::numbers::pi / 180));
        if (!wall.contactAngles.empty())
            reading.theCase.diagnostics().error(
                wall.anglesAt,
                fmt::format(
                    "wall \"{}\": contactAngles are of pairs of phases, and with `gas none;` of system/sphSchemes there is one: give contactAngle",
                    wall.name));
        else if (angle > largestAngle)
            reading.theCase.diagnostics().error(
                wall.anglesAt,
                fmt::format(
                    "wall \"{}\": {} degrees are more than the {} that a wall holds without gas: drops leave it. Take `gas band;` or `gas whole;` of system/sphSchemes, with the gas as a phase",
                    wall.name, angle, largestAngle));
    }
    if (!neutral) c.set(angles);
}

/// gamma_sk of each wall, by Young's law from its contact angles. None where every angle is 90 degrees.
void setContactAngles(const Reading& reading, Coefficients& c)
{
    const std::size_t n = c.phases.size();
    if (!reading.geometry.wets()) return;
    if (isLiquidAlone(reading.settings)) return setAnglesOfLiquidAlone(reading, c);
    if (n < 2)
        return refuseAngles(reading,
                            "it is one of two phases, and constant/phaseProperties lists one, whose free surface has no tension. Add the "
                            "gas as a phase, and sigma between both; or leave the angle out");
    if (!tensionsOf(c).any() && !entry::surfaceTension.is(reading.schemes, "none"))
        return refuseAngles(reading, "constant/phaseProperties gives no sigma between any two phases. Give it, or leave the angle out");
    WettingAngles angles;
    std::vector<double> tensions;
    bool neutral = true;
    for (const auto& wall : reading.geometry.walls)
    {
        const auto complain = [&](const std::string& what)
        { reading.theCase.diagnostics().error(wall.anglesAt, fmt::format("wall \"{}\": {}", wall.name, what)); };
        const auto known = phaseAngles(wall, c, complain);
        for (const auto& pair : known) neutral = neutral && pair.angle == 90;
        for (double tension : wallTensions(known, c, complain)) tensions.push_back(tension);
        angles.cosine.push_back(n == 2 && !known.empty() ? cosineThroughFirst(known.front()) : 0);
    }
    if (!tensionsOf(c).any() || neutral) return;
    c.of<Tensions>().ofWalls = tensions;
    c.set(angles);
}

/// Whether the tensions of more than two phases are sums of a share of each, as the curvature form has them; those of three always are.
bool haveShares(const Coefficients& c)
{
    const double roundOff = 1e-9;
    return c.phases.size() < 4 || missedByShares(c) < roundOff;
}

/// All particles are of one phase. A band of gas joins it where it is missing.
bool isAlone(const Settings& settings) { return settings.facts.get<LonePhase>().phase >= 0 && settings.facts.get<PhaseInPart>().phase < 0; }

/// A phase alone has no interface, and needs no pass for it. All else stays as beside another phase: without the limit of the step and the background pressure (models/pressure) an implicit step of a light gas is as long as
/// its weight allows, and the gas comes to no rest (tutorials/stiff/gasAtRest).
void leaveOut(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& c = settings.coefficients;
    c.of<Tensions>().ofWalls.clear();
    reading.choose(entry::contactAngle, "wallPotential");
    settings.facts.give(ForceReach{2}, "the particles of the first time");
    const bool acts = reading.choose(entry::surfaceTension, "curvature") != "none";
    settings.chosen[entry::surfaceTension.keyword()] = "none";
    if (!acts) return;
    settings.facts.give(InterfaceForces{true}, "surfaceTension of system/sphSchemes");
    settings.reasons.push_back(fmt::format("no surface tension: all particles are of {}, and nothing brings others",
                                           c.phases[std::size_t(settings.facts.get<LonePhase>().phase)]));
}

/// The curvature form is the more exact and the calmer (tutorials laplaceDrop, contactAngle, bccBed, liquidLens); it goes with the wall potential. The
/// walls' stresses go with the stress form alone.
void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& c = settings.coefficients;
    const auto& dict = reading.schemes;
    setContactAngles(reading, c);
    if (isAlone(settings)) return leaveOut(reading);
    const bool tension = tensionsOf(c).any();
    const bool stress = reading.paper() || (tension && !haveShares(c)) || entry::contactAngle.is(dict, "paper") ||
                        entry::contactAngle.is(dict, "wallStress");
    const auto& form = reading.choose(entry::surfaceTension, !tension ? "none" : stress ? "interfaceStress" : "curvature");
    const bool acts = form != "none";
    if (acts && tension) settings.facts.give(InterfaceForces{true}, "surfaceTension of system/sphSchemes");
    settings.facts.give(ForceReach{!acts ? 2 : form == "curvature" ? 4 : 3}, "surfaceTension of system/sphSchemes");
    if (!acts) c.of<Tensions>().ofWalls.clear();
    if (acts && !tension) entry::surfaceTension.error(dict, "constant/phaseProperties gives no sigma between any two phases");
    else if (acts && isLiquidAlone(settings) && form != "curvature")
        entry::surfaceTension.error(dict, "of a liquid whose gas is left out (`gas none;`) is by curvature: take that, or leave this out");
    else if (form == "curvature" && !haveShares(c))
        settings.reasons.push_back(fmt::format(
            "surface tensions of {} phases by a share of each: where three meet they balance to {:.2g} of the largest; interfaceStress "
            "has them exactly",
            c.phases.size(), missedByShares(c)));
}

void readAngles(const Reading& reading)
{
    auto& settings = reading.settings;
    const auto& dict = reading.schemes;
    if (isLiquidAlone(settings))
        return reading.doesNothing(entry::contactAngle,
                                   "with `gas none;` it is by the curvature of the free surface (src/models/tension/WallWetting.hpp)");
    const bool byCurvature = settings.has(entry::surfaceTension, "curvature"),
               byStress = settings.has(entry::surfaceTension, "interfaceStress");
    const auto& form = reading.choose(entry::contactAngle, byCurvature                   ? "wallPotential"
                                                           : reading.paper() && byStress ? "paper"
                                                                                         : "wallStress");
    if (form == "paper" && !byStress)
        entry::contactAngle.error(
            dict, fmt::format("paper makes the solid a phase of the interface stress and goes with surfaceTension interfaceStress, not "
                              "{}; take wallStress or wallPotential",
                              settings.chosen.at(entry::surfaceTension.keyword())));
    if (form == "wallPotential" && byStress && reading.geometry.wets())
        dict.diagnostics().warning(
            entry::contactAngle.where(dict),
            "wallPotential asks the interface to bend beside the wall, which interfaceStress does not: contact angles are 7 to 9 "
            "degrees off (tutorials/verification/contactAngle). Take surfaceTension curvature, or contactAngle wallStress");
    if (form == "wallAdhesion" && byStress)
        entry::contactAngle.error(
            dict,
            "wallAdhesion turns the normals of surfaceTension curvature, and interfaceStress has none; take wallStress or wallPotential");
    if (entry::contactAngle.given(dict) && (!settings.facts.get<InterfaceForces>().act || !reading.geometry.wets()))
        entry::contactAngle.error(dict, fmt::format("does nothing without {}; give that, or leave this out",
                                                    reading.geometry.wets() ? "surface tension between two phases"
                                                                            : "a wall that has a contactAngle in constant/geometry"));
    // A solid of 90 degrees has no tension, but it is no fluid either: the fluids' colour gradients end at it.
    auto& c = settings.coefficients;
    if (form != "paper" || !byStress || !reading.geometry.wets()) return;
    c.of<Tensions>().ofWalls.resize(reading.geometry.walls.size() * c.phases.size());
    settings.reasons.push_back("contact angles by the solid as a phase of its own, as in the paper");
}

/// Surface tension of a liquid alone.
void readFreeSurface(const Reading& reading)
{
    auto& settings = reading.settings;
    settings.runningModels.push_back(running<FreeSurfaceArea>());
    settings.define<LiquidNormals>("liquidNormals", [](const Coefficients&) { return LiquidNormals{}; });
    const double beta = depthBias(settings.resolution.kernel, settings.coefficients.dimension),
                 closest = settings.facts.get<WallClearance>().spacings * settings.coefficients.spacing;
    LinesOfContact lines;
    for (const auto& wall : reading.geometry.walls) lines.at.push_back(wall.wets || !wall.slips);
    if (std::ranges::count(lines.at, true) == 0)
        settings.define<FreeSurfaceCurvature>("freeSurfaceCurvature",
                                              [beta](const Coefficients& c) { return FreeSurfaceCurvature(c, beta); });
    else
    {
        settings.coefficients.set(lines);
        settings.define<DistanceNextTo>("distanceNextTo", [](const Coefficients& c) { return DistanceNextTo(c); });
        reading.select("distanceNextTo");
        settings.define<FreeSurfaceCurvatureAtWalls>("freeSurfaceCurvature", [beta, closest](const Coefficients& c)
                                                     { return FreeSurfaceCurvatureAtWalls(c, beta, closest); });
    }
    if (settings.coefficients.has<WettingAngles>())
    {
        settings.define<WallWetting>("wallWetting", [closest](const Coefficients& c) { return WallWetting(c, closest); });
        settings.facts.give(WallReach{WallWetting::reachInSupports}, "contactAngle of constant/geometry");
        settings.define<WettedSurfaceSmoothing>("freeSurfaceSmoothing", [](const Coefficients&) { return WettedSurfaceSmoothing{}; });
    }
    else settings.define<FreeSurfaceSmoothing>("freeSurfaceSmoothing", [](const Coefficients&) { return FreeSurfaceSmoothing{}; });
    settings.define<FreeSurfaceForce>("freeSurfaceForce", [](const Coefficients& c) { return FreeSurfaceForce(c); });
    settings.define<AddTension>(
        "addTension", [](const Coefficients&) { return AddTension{}; }, settings.separateSums);
    for (const char* term : {"liquidNormals", "freeSurfaceCurvature", "freeSurfaceSmoothing", "freeSurfaceForce", "addTension"})
        reading.select(term);
    settings.state.push_back({.value = stateField(ParticleNumber{}), .advancedByModel = true, .written = false});
    settings.define<CountGhosts>("countGhosts", [](const Coefficients&) { return CountGhosts{}; });
    reading.select("countGhosts");
    settings.runningModels.push_back(running<FreeBodies>());
    if (settings.integration.maxSubSteps > 1)
        reading.schemes.subDictOrEmpty("integration")
            .error("maxSubSteps", "substeps go with surface tension between phases, not with that of `gas none;`");
}

/// Surface tension acts once in a step of several parts, in its middle: its curvature is four of the six sums over pairs of a two-phase step.
/// Viscosity shares its sum with the pressure: nothing would be gained.
void read(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& c = settings.coefficients;
    if (isAlone(settings)) return;
    readAngles(reading);
    if (isLiquidAlone(settings))
    {
        if (settings.facts.get<InterfaceForces>().act) readFreeSurface(reading);
        return;
    }
    const bool seldom = settings.integration.maxSubSteps > 1;
    const auto select = [&](const std::string& term) { (seldom ? settings.slowTerms : settings.terms).push_back(term); };
    if (settings.facts.get<InterfaceForces>().act) settings.runningModels.push_back(running<InterfaceArea>());
    const bool angles = !tensionsOf(c).ofWalls.empty();
    const auto by = [&](const char* form) { return angles && settings.has(entry::contactAngle, form); };
    if (by("paper"))
    {
        select("solidPhaseStress");
        select("stressOfSolid");
    }
    else if (settings.has(entry::surfaceTension, "interfaceStress")) select("interfaceStress");
    if (by("wallStress"))
    {
        select("wallTension");
        c.set(KernelMarginal::of(settings.resolution.kernel, c.dimension, c.support));
    }
    if (settings.has(entry::surfaceTension, "interfaceStress") || by("wallStress"))
        select(settings.force(settings.facts.get<PressureForce>().form == PressureForce::Form::densityWeighted
                                  ? "densityWeightedStressDivergence"
                                  : "stressDivergence",
                              operatorTerms<2>(), operatorTerms<3>()));
    if (settings.has(entry::surfaceTension, "curvature") && c.phases.size() > 2)
    {
        const bool even = !seldom && settings.facts.get<PressureForce>().hasEnergy();
        for (const auto& term : definePhaseCurvature(settings, {.even = even, .adhering = by("wallAdhesion")})) select(term);
    }
    else if (settings.has(entry::surfaceTension, "curvature"))
    {
        select(settings.force(!seldom && settings.facts.get<PressureForce>().hasEnergy() ? "evenCurvatureForce" : "curvatureForce",
                              tensionTerms<2>(), tensionTerms<3>()));
        select(by("wallAdhesion") ? "adheringColourGradient" : "smoothedColourGradient");
    }
    if (by("wallAdhesion")) settings.facts.give(InterfacesBehindWalls{true}, "contactAngle of system/sphSchemes");
    if (by("wallPotential")) select("wallPotential");
    if (!seldom) return;
    if (settings.slowTerms.empty())
        reading.schemes.subDictOrEmpty("integration").error("maxSubSteps", "without surface tension nothing acts more slowly than sound");
    else
        settings.reasons.push_back(fmt::format("up to {} parts to a step: surface tension acts in the middle one alone, all else in each",
                                               settings.integration.maxSubSteps));
}

/// s sqrt((rho_k + rho_l) h^3/(4 pi gamma)), s = 0.5, of the pair of phases that allows least; half as long where it acts once in a step of several parts.
std::optional<StepLimit> capillaryLimit(const Settings& settings, const Measured&)
{
    const auto& c = settings.coefficients;
    const double h = 0.5 * c.support, s = settings.integration.factors.capillary;
    const auto& between = tensionsOf(c).between;
    if (between.empty()) return {};
    const std::size_t n = c.phases.size();
    double step = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k)
        for (std::size_t l = 0; l < n; ++l)
            if (const double gamma = between[k * n + l]; gamma > 0)
            {
                const double rho = n > 1 ? c.restDensity[k] + c.restDensity[l] : c.restDensity[0]; // beyond a free surface there is none
                step = std::min(step, std::sqrt(rho * h * h * h / (4 * std::numbers::pi * gamma)));
            }
    if (!(step < std::numeric_limits<double>::infinity())) return {};
    return StepLimit{s * step, "capillary"};
}

/// s sqrt(h/|dv/dt|), s = 0.25, of what acts once in a step.
std::optional<StepLimit> slowForceLimit(const Settings& settings, const Measured& measured)
{
    if (!(measured.maxSlowAcceleration > 0)) return {};
    return StepLimit{settings.integration.factors.force * std::sqrt(0.5 * settings.coefficients.support / measured.maxSlowAcceleration),
                     "slow force", false, &SlowAcceleration::info};
}

template<int dim> Catalogue<dim> allTerms()
{
    auto terms = tensionTerms<dim>();
    for (auto& law : wettingLaws<dim>()) terms.push_back(std::move(law));
    return terms;
}
}

const Model& tensionModel()
{
    static const Model model{"surfaceTension",
                             "surface tension between phases, and the contact angles of walls",
                             read,
                             allTerms<2>(),
                             allTerms<3>(),
                             prepare,
                             {},
                             {capillaryLimit, slowForceLimit},
                             {{"constant/phaseProperties", {entry::sigma, {entry::phaseName, {entry::sigmaOfSurface}}}},
                              {"system/sphSchemes", {entry::surfaceTension, entry::contactAngle}}},
                             declare};
    return model;
}

}
