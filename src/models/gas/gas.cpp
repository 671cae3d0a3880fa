#include "models/gas/gas.hpp"
#include "geometry/OpenEnds.hpp"
#include "geometry/makeWallLayers.hpp"
#include "models/gas/AmbientGas.hpp"
#include "models/gas/CalmGas.hpp"
#include "models/gas/CompletedDensity.hpp"
#include "models/gas/GasBand.hpp"
#include "models/gas/GasFriction.hpp"
#include "models/gas/gasTerms.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace sph
{

namespace entry
{
const Choice gas{
    "gas",
    {{"whole", "wherever there is no liquid"},
     {"calm",
      "as `whole`, and without the lattice of its background pressure far from the liquid: it stays at rest where nothing moves it"},
     {"band", "within some supports of the liquid, at a constant pressure beyond: where nothing asks for the motion of the gas"},
     {"none", "left out: the one phase is a liquid, whose free surface has the pressure 0, and the tension `sigma` of the phase"}},
    byScene("calm where all particles are of the lightest phase; else whole"),
    "where the gas is, the lightest phase"};
const Scalar gasBand{"gasBand", Unit{units::none, "supports"}, 3, between(2.5, 40),
                     "width of the band, with `gas band;`: its outer support stands still"},
    gasFriction{"gasFriction", units::none / units::s, 0, nonNegative, "r of a friction of the gas, dv/dt = -(r + 2 |v|/spacing) v"};
}

namespace
{
/// The distance from walls at which a liquid alone is held [spacings]: suction, which no gas's pressure outweighs, draws a particle to its own image, from which nothing but such a distance keeps it. Rows at a line of contact lay 0.02 spacings off the wall,
/// where viscosity holds them: a half ball of 24 spacings stayed at 80 degrees for 60 (README.md).
constexpr double closestToWalls = 0.4;

std::size_t lightest(const Coefficients& c) { return std::size_t(std::ranges::min_element(c.restDensity) - c.restDensity.begin()); }

void declare(const Reading& reading)
{
    if (entry::gas.is(reading.schemes, "none")) reading.settings.facts.give(GasLeftOut{true}, "gas of system/sphSchemes");
}

void prepareLiquidAlone(const Reading& reading)
{
    auto& settings = reading.settings;
    const auto& c = settings.coefficients;
    if (settings.multiphase())
        return entry::gas.error(
            reading.schemes,
            fmt::format("none leaves the liquid alone, and constant/phaseProperties lists {}: leave the gas's name and dictionary "
                        "out, and give the liquid's dictionary the surface tension as sigma",
                        fmt::join(c.phases, ", ")));
    const auto surface = FlatSurface::of(settings.resolution.kernel, c.dimension, c.support, c.spacing);
    settings.reasons.push_back(fmt::format(
        "no gas: density completed by what plane surfaces lack, {:.3g} t {:+.3g} t^2 {:+.3g} t^3, which rows of lattices are {:.2g} off",
        surface.density[0], surface.density[1], surface.density[2], surface.densityMisfit));
    settings.coefficients.set(surface);
    settings.facts.give(FreeSurface{true}, "gas of system/sphSchemes");
    settings.facts.give(WallClearance{closestToWalls}, "gas of system/sphSchemes");
    settings.define<CompletedVolume>("completedVolume", [](const Coefficients& q) { return CompletedVolume(q); });
    settings.define<UniformNormalisation>("uniformNormalisation", [](const Coefficients& q) { return UniformNormalisation(q); });
}

void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    auto& c = settings.coefficients;
    // Alone, nothing hangs on the lattice of its background pressure.
    const bool alone = settings.facts.get<LonePhase>().phase == int(lightest(c));
    const auto& gas = reading.choose(entry::gas, alone ? "calm" : "whole");
    if (gas != "band" && entry::gasBand.given(reading.schemes))
        entry::gasBand.error(reading.schemes, "is the width of `gas band;`: give that, or leave this out");
    if (gas == "none") return prepareLiquidAlone(reading);
    if (gas == "whole") return;
    if (!settings.multiphase())
        return entry::gas.error(reading.schemes, gas + " is of the lightest of several phases, and constant/phaseProperties lists one");
    const auto phase = lightest(c);
    if (gas == "calm")
    {
        Evolving share{stateField(Ambient{})};
        share.written = false;
        settings.state.push_back(share);
        return settings.facts.give(CalmPhase{int(phase)}, "gas of system/sphSchemes");
    }
    c.set(GasAtRest::of(c.restDensity[phase], settings.resolution.kernel, c.dimension, c.support, c.spacing));
    settings.state.push_back({stateField(Ambient{})});
    settings.facts.give(PhaseInPart{int(phase)}, "gas of system/sphSchemes");
}

void slowGas(const Reading& reading, double rate)
{
    auto& settings = reading.settings;
    const auto& c = settings.coefficients;
    if (!settings.multiphase())
        return entry::gasFriction.error(reading.schemes, "is of the lightest of several phases, and constant/phaseProperties lists one");
    const auto gas = lightest(c);
    settings.reasons.push_back(fmt::format(
        "friction of {}: driven at v m/s over L m it resists by ({:.3g} + {:.3g} v) v L Pa; capillary pressures are {:.3g}/R Pa",
        c.phases[gas], rate * c.restDensity[gas], 2 / c.spacing * c.restDensity[gas], settings.facts.get<InterfaceEnergy>().largest));
    settings.runningModels.push_back(running<GasFriction>(gas, rate));
}

/// The planes of the openings of a case.
SceneEnds openingsOf(const Reading& reading)
{
    const auto& settings = reading.settings;
    if (!settings.facts.get<OpenBoundary>().exists) return {};
    const auto ends = std::make_shared<const OpenEnds>(reading.theCase, reading.geometry, settings.resolution);
    const double support = settings.coefficients.support;
    return {[ends](const Vector<3>& x) { return ends->nearest(x); }, support, settings.facts.get<ForceReach>().supports * support};
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    const int inPart = settings.facts.get<PhaseInPart>().phase, calm = settings.facts.get<CalmPhase>().phase;
    if (const double rate = entry::gasFriction(reading.schemes); rate > 0) slowGas(reading, rate);
    if (inPart < 0 && calm < 0) return;
    reading.select(settings.force("ambientPressure", gasTerms<2>(), gasTerms<3>()));
    settings.runningModels.push_back(inPart < 0
                                         ? running<CalmGas>(std::size_t(calm))
                                         : running<GasBand>(std::size_t(inPart), entry::gasBand(reading.schemes), openingsOf(reading)));
}

bool isInPart(const Settings& settings) { return settings.facts.get<PhaseInPart>().phase >= 0; }
bool isCalm(const Settings& settings) { return settings.facts.get<CalmPhase>().phase >= 0; }

bool isLeftOut(const Settings& settings) { return settings.facts.get<GasLeftOut>().isLeftOut; }

/// 3 s h/c, s = 0.4, of steps that solve for the pressure: their response is that of the number density, and does not know how a completed one changes with the sum of slopes. A ball of 8 spacings to the radius comes to rest
/// up to c dt/h = 1.2 (rho c^2 = 50 gamma/dx), keeps 1.2 mJ of motion in place of 1 uJ at 1.9, and 30 mJ at 2.9.
std::optional<StepLimit> completionLimit(const Settings& settings, const Measured&)
{
    const auto& c = settings.coefficients;
    if (!isLeftOut(settings) || !settings.integration.solvesPressure) return {};
    return StepLimit{3 * settings.integration.factors.sound * 0.5 * c.support / c.soundSpeed[0], "sound at the free surface"};
}
}

const Model& gasModel()
{
    static const Model model{
        "gas",
        "where the gas is: everywhere, in a band around the liquid, or nowhere; and how calm",
        read,
        gasTerms<2>(),
        gasTerms<3>(),
        prepare,
        {{"gas",
          [](const Settings& s)
          { return (isInPart(s) || isCalm(s)) && (!s.facts.get<PressureForce>().hasEnergy() || s.facts.get<IntegratedDensity>().exists); },
          "band and calm go with `density numberDensity` and `pressureGradient huAdams`"},
         {"gas",
          [](const Settings& s) { return isCalm(s) && !(s.coefficients.backgroundPressure > 0) && s.facts.get<LonePhase>().phase < 0; },
          "calm leaves out a backgroundPressure above 0, and there is none"},
         {"gas", [](const Settings& s) { return isInPart(s) && !(s.coefficients.backgroundPressure > 0); },
          "band needs a backgroundPressure above 0, which is that of the gas beyond it"},
         {"gas",
          [](const Settings& s)
          { return isLeftOut(s) && (!s.facts.get<PressureForce>().hasEnergy() || s.facts.get<IntegratedDensity>().exists); },
          "none goes with `density numberDensity` and `pressureGradient huAdams`"},
         {"gas", [](const Settings& s) { return isLeftOut(s) && s.facts.get<ConstitutiveStress>().exists; },
          "none completes the density of a liquid with a state equation, not a soil"},
         {"gas", [](const Settings& s) { return isLeftOut(s) && s.facts.get<VaryingViscosity>().exists; },
          "none has not been measured with a suspension"},
         {"gas", [](const Settings& s) { return isLeftOut(s) && s.has(entry::wallKind, "layers"); },
          "none goes with `walls reflected`: the free surface goes on in their mirror images"},
         {"gas", [](const Settings& s) { return isLeftOut(s) && s.coefficients.backgroundPressure != 0; },
          "none leaves out the gas, and with it the backgroundPressure: the free surface has the pressure 0"},
         {"gas", [](const Settings& s) { return isLeftOut(s) && std::ranges::count(s.terms, "transportStress") > 0; },
          "none goes without transportVelocity, which pushes particles out of a free surface"}},
        {completionLimit},
        {{"system/sphSchemes", {entry::gas, entry::gasBand, entry::gasFriction}}},
        declare};
    return model;
}

}
