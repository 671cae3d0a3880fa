#include "models/walls/walls.hpp"
#include "geometry/makeWallLayers.hpp"
#include "models/walls/WallContact.hpp"
#include "models/walls/WallRules.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace entry
{
const Choice wallVelocity{
    "wallVelocity",
    {{"secondOrder", "no slip, from the momentum balance at the wall"},
     {"reflected", "no slip, first order in the distance"},
     {"morris", "Morris et al. (1997) with their limit of 1.5, for walls layers"},
     "freeSlip"},
    byScene(
        "secondOrder with huAdams, where all phases have mu and neither surface tension nor powder is there; morris with soil between layers; else reflected"),
    "of what lies behind a wall"},
    wallPressure{"wallPressure",
                 {{"hydrostatic", "continues that of a fluid at rest"},
                  {"detaching", "the same without suction"},
                  {"mirrored", "that of the source"}},
                 byScene("hydrostatic; mirrored with scheme paper"),
                 "of what lies behind a wall"},
    layerValues{"layerValues",
                {{"byPair", "what a particle sees in one of a layer follows from that particle alone"},
                 {"interpolated",
                  "one value for each particle of a layer, fitted along the wall to what the rules make of all within reach"}},
                byScene("interpolated with soil, else byPair"),
                "of velocities and stresses in walls layers; pressures are means"};
}

namespace
{
/// Whether all phases are viscous, by mu or by a model of it.
bool viscous(const Settings& s)
{
    return std::all_of(s.coefficients.viscosity.begin(), s.coefficients.viscosity.end(), [](double mu) { return mu > 0; });
}

void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    const auto& dict = reading.schemes;
    const auto& geometry = reading.geometry;
    const bool layers = wallsAreLayers(dict);
    settings.chosen[entry::wallKind.keyword()] = layers ? "layers" : "reflected";
    if (layers && geometry.patches.empty()) dict.error("walls", "there are none in constant/geometry");
    const bool hasStress = settings.facts.get<ConstitutiveStress>().exists;
    if (layers) reading.choose(entry::layerValues, hasStress ? "interpolated" : "byPair");
    else if (entry::layerValues.given(dict))
        entry::layerValues.error(dict, "goes with `walls layers;` alone: mirror images have no values of their own");
    const bool interpolates = settings.has(entry::layerValues, "interpolated");
    if (geometry.slips())
    {
        std::vector<std::string> names;
        for (const auto& wall : geometry.walls)
            if (wall.slips) names.push_back(wall.name);
        settings.reasons.push_back(fmt::format("the fluid slides along {} freely", fmt::join(names, ", ")));
        if (layers && !interpolates)
            dict.error(
                "walls",
                fmt::format("{} of constant/geometry with `slip yes;` needs what carries the velocity along the wall from place to place; "
                            "take walls reflected, or layerValues interpolated",
                            fmt::join(names, ", ")));
    }
    if (const auto* wall = geometry.withFriction(); wall && layers)
        dict.error(
            "walls",
            fmt::format("{} of constant/geometry with a frictionAngle needs ghosts that carry its shear stress; take walls reflected",
                        wall->name));
    if (!geometry.layers.empty())
        settings.reasons.push_back(
            fmt::format("walls of {} particles in layers, whose velocity continues the fluid's beyond the surface; nothing is mirrored",
                        geometry.layers.size()));
    // Measured: two layers of water and air have 0.06 % of error by it in place of 0.16 (tutorials/verification/twoLayerPoiseuille). A bed of grains with
    // surface tension has three times the kinetic energy at 4 ms, and a channel of powder, whose gradient of mu the rule leaves out, 5.0 % of error in U
    // in place of 3.0.
    const bool powder = settings.facts.get<VaryingViscosity>().exists;
    const bool second = !reading.paper() && !geometry.patches.empty() && viscous(settings) &&
                        settings.facts.get<PressureForce>().hasEnergy() && !settings.facts.get<InterfaceForces>().act && !powder;
    // Without the limit a column of soil between layers that hold it diverged (models/soil/README.md).
    const auto& rule = reading.choose(entry::wallVelocity, second ? "secondOrder" : layers && hasStress ? "morris" : "reflected");
    if (rule != "secondOrder") return;
    settings.separateSums[Acceleration::info.name] = PressureAcceleration::info.name;
    settings.state.push_back({stateField(WallAcceleration{})});
    auto& reads = settings.ruleReads[Velocity::info.name];
    reads = {stateField(WallAcceleration{})};
    if (!settings.hasViscosityField()) return;
    reads.push_back(stateField(DynamicViscosity{}));
    reads.push_back(stateField(Density{}));
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    const auto& c = settings.coefficients;
    const auto& geometry = reading.geometry;
    const auto& pressure = reading.choose(entry::wallPressure, reading.paper() ? "mirrored" : "hydrostatic");
    if (geometry.patches.empty())
        for (const auto* entry : {&entry::wallVelocity, &entry::wallPressure})
            reading.doesNothing(*entry, "there are no walls in constant/geometry");
    else if (std::ranges::all_of(geometry.walls, &WallProperties::slips))
        reading.doesNothing(entry::wallVelocity, "all walls of constant/geometry have `slip yes`");
    if (!geometry.patches.empty() && !settings.hasGravity() && !(mag(c.bodyForce) > 0))
        reading.doesNothing(entry::wallPressure,
                            "without gravity and body force the pressure behind a wall is that of the fluid before it");
    const bool continued = pressure != "mirrored" && !geometry.patches.empty() && (settings.hasGravity() || mag(c.bodyForce) > 0);
    if (continued) settings.ruleReads[Pressure::info.name] = {stateField(Density{})};
    settings.facts.give(LeakedParticles{readLeakGuard(reading.schemes)}, "leakedParticles of system/sphSchemes");
    settings.facts.give(WallConditions{settings.has(entry::wallVelocity, "freeSlip"), settings.has(entry::layerValues, "interpolated"),
                                       pressure},
                        "the walls of system/sphSchemes");
    settings.runningModels.push_back(running<WallRules>(settings.chosen.at(entry::wallVelocity.keyword()),
                                                        continued ? pressure : std::string("mirrored"), settings.hasViscosityField(),
                                                        settings.has(entry::layerValues, "interpolated")));
    if (!geometry.patches.empty())
        settings.runningModels.push_back(
            running<WallContact>(settings.facts.get<ConstitutiveStress>().exists, settings.has(entry::wallVelocity, "freeSlip")));
}
}

const Model& wallsModel()
{
    static const Model model{
        "walls",
        "how the fluid continues into its walls: velocity and pressure of ghosts, or of particles in layers",
        read,
        {},
        {},
        prepare,
        {{"wallVelocity", [](const Settings& s) { return s.has(entry::layerValues, "byPair") && s.has(entry::wallVelocity, "freeSlip"); },
          "freeSlip needs what carries the velocity along the wall from place to place; take walls reflected, or layerValues interpolated"},
         {"layerValues", [](const Settings& s) { return s.has(entry::layerValues, "interpolated") && s.integration.solves; },
          "interpolated velocities of walls depend on all particles within reach, which implicit solves do not know of: take byPair, or an explicit scheme"},
         {"wallVelocity", [](const Settings& s) { return s.has(entry::wallVelocity, "morris") && !s.has(entry::wallKind, "layers"); },
          "morris limits the velocity of a particle of the wall that lies deeper than that of the fluid before it; mirror images lie as deep: take reflected, "
          "or walls layers"},
         {"wallVelocity",
          [](const Settings& s)
          { return s.has(entry::wallVelocity, "secondOrder") && (!viscous(s) || !s.facts.get<PressureForce>().hasEnergy()); },
          "secondOrder needs viscosity in all phases and pressureGradient huAdams; take reflected"},
         {"wallVelocity",
          [](const Settings& s)
          { return s.has(entry::wallVelocity, "secondOrder") && s.facts.get<InterfaceForces>().act && s.integration.maxSubSteps > 1; },
          "secondOrder sees surface tension where it acts in every part of a step: take maxSubSteps 1, or reflected"},
         {"walls", [](const Settings& s) { return s.has(entry::wallKind, "layers") && s.facts.get<InterfaceForces>().act; },
          "layers have no interface to continue: with surface tension take walls reflected"}},
        {},
        {{"system/sphSchemes", {entry::wallVelocity, entry::wallPressure, entry::layerValues}},
         {"system/sphSchemes", wallLayersEntries()},
         {"system/sphSchemes", leakGuardEntries()}}};
    return model;
}

}
