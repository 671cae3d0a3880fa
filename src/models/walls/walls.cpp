#include "walls.hpp"
#include "WallRules.hpp"
#include "wallLayers.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace entry
{
const Choice wallVelocity{"wallVelocity",
                          {{"secondOrder", "no slip, from the momentum balance at the wall"}, {"reflected", "no slip, first order in the distance"}, "freeSlip"},
                          byScene("secondOrder for one phase of uniform viscosity, else reflected"),
                          "of what lies behind a wall"},
    wallPressure{"wallPressure",
                 {{"hydrostatic", "continues that of a fluid at rest"}, {"detaching", "the same without suction"}, {"mirrored", "that of the source"}},
                 byScene("hydrostatic; mirrored with scheme paper"),
                 "of what lies behind a wall"};
}

namespace
{
void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    const auto& c = settings.coefficients;
    const auto& dict = reading.schemes;
    const auto& geometry = reading.geometry;
    const bool layers = wallsAreLayers(dict), viscous = std::any_of(c.viscosity.begin(), c.viscosity.end(), [](double mu) { return mu > 0; });
    settings.chosen["walls"] = layers ? "layers" : "reflected";
    if (layers && geometry.patches.empty()) dict.error("walls", "there are none in constant/geometry");
    if (!geometry.layers.empty())
        settings.reasons.push_back(fmt::format("walls of {} particles in layers, whose velocity continues the fluid's beyond the surface; nothing is mirrored",
                                               geometry.layers.size()));
    const bool second = !reading.paper() && !geometry.patches.empty() && viscous && !settings.variableViscosity;
    const auto& rule = reading.choose(entry::wallVelocity, second ? "secondOrder" : "reflected");
    if (rule != "secondOrder") return;
    settings.apart[Acceleration::info.name] = PressureAcceleration::info.name;
    settings.state.push_back({stateField(WallAcceleration{})});
    auto& reads = settings.ruleReads[Velocity::info.name];
    reads = {stateField(WallAcceleration{})};
    if (!settings.variableViscosity) return;
    reads.push_back(stateField(DynamicViscosity{}));
    reads.push_back(stateField(Density{}));
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    const auto& c = settings.coefficients;
    const auto& geometry = reading.geometry;
    const auto& pressure = reading.choose(entry::wallPressure, reading.paper() ? "mirrored" : "hydrostatic");
    const bool continued = pressure != "mirrored" && !geometry.patches.empty() && (mag(c.g) > 0 || mag(c.bodyForce) > 0);
    if (continued) settings.ruleReads[Pressure::info.name] = {stateField(Density{})};
    settings.leaked = readLeakGuard(reading.schemes);
    settings.weighted = std::any_of(geometry.patches.begin(), geometry.patches.end(), [](const Patch& p)
                                    { return p.shape->smallestRadius() < std::numeric_limits<double>::infinity() || p.shape->hasEdges(); });
    settings.parts.push_back(partOf<WallRules>(settings.chosen.at("wallVelocity"), continued ? pressure : std::string("mirrored"), settings.variableViscosity));
}

bool viscous(const Settings& s)
{
    return std::any_of(s.coefficients.viscosity.begin(), s.coefficients.viscosity.end(), [](double mu) { return mu > 0; });
}
}

const Model& wallsModel()
{
    static const Model model{
        "walls", "how the fluid continues into its walls: velocity and pressure of ghosts, or of particles in layers", read, {}, {}, prepare,
        {{"wallVelocity", [](const Settings& s) { return s.has("walls", "layers") && s.has("wallVelocity", "freeSlip"); },
          "freeSlip needs ghosts that carry the velocity along the wall from place to place; take walls reflected"},
         {"wallVelocity",
          [](const Settings& s) { return s.has("wallVelocity", "secondOrder") && (!viscous(s) || !s.has("pressureGradient", "huAdams")); },
          "secondOrder needs viscosity and pressureGradient huAdams; take reflected"},
         {"wallVelocity",
          [](const Settings& s) { return s.has("wallVelocity", "secondOrder") && s.surfaceTension && s.integration.maxSubSteps > 1; },
          "secondOrder sees surface tension where it acts in every part of a step: take maxSubSteps 1, or reflected"},
         {"walls", [](const Settings& s) { return s.has("walls", "layers") && s.surfaceTension; },
          "layers have no interface to continue: with surface tension take walls reflected"}},
        {}, {{"system/sphSchemes", {entry::wallVelocity, entry::wallPressure}}, {"system/sphSchemes", wallLayersEntries()}, {"system/sphSchemes", leakGuardEntries()}}};
    return model;
}

}
