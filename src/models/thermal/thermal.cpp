#include "models/thermal/thermal.hpp"
#include "geometry/makeWallLayers.hpp"
#include "models/scalarTransport/carriedScalar.hpp"
#include "models/scalarTransport/mirrorsPairwise.hpp"
#include "models/thermal/HeatBalance.hpp"
#include "models/thermal/readThermal.hpp"
#include "models/thermal/thermalTerms.hpp"
#include <algorithm>

namespace sph
{

namespace
{
bool anyPasses(const ThermalProperties& thermal) { return std::ranges::any_of(thermal.walls, &HeatAtWall::passes); }
/// Whether ghosts of conduction differ by the walls that they were mirrored in.
bool differsByWall(const ThermalProperties& thermal, const Geometry& geometry)
{
    return !geometry.patches.empty() && (anyPasses(thermal) || !mirrorsPairwise(geometry));
}

void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    if (!reading.theCase.has(thermophysicalProperties)) return;
    auto thermal = readThermal(reading);
    for (const auto& evolving : settings.state)
        if (evolving.value.name == Temperature::info.name)
            reading.schemes.diagnostics().error(
                {thermophysicalProperties, 0},
                "the temperature is the field T, and constant/scalarTransport has a scalar of that name: leave one of the two out");
    settings.state.push_back(
        carriedScalar(stateField(Temperature{}), stateField(TemperatureRate{}), thermal.initial, thermophysicalProperties));
    if (differsByWall(thermal, reading.geometry))
        settings.state.push_back({.value = stateField(HeatedWall{}), .advancedByModel = true, .written = false});
    for (const auto& wall : thermal.walls)
        if (wall.passes()) settings.state.push_back({stateField(WallHeat{}, wall.heatName()), stateField(WallHeatRate{}, wall.rateName())});
    if (settings.multiphase()) settings.ruleReads[Temperature::info.name] = {stateField(Phase{})};
    settings.coefficients.set(std::move(thermal));
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    if (!settings.coefficients.has<ThermalProperties>()) return;
    const auto& thermal = settings.coefficients.of<ThermalProperties>();
    const auto& geometry = reading.geometry;
    for (const auto& term : defineConduction(settings, thermal, differsByWall(thermal, geometry))) reading.select(term);
    std::string wallPressure;
    if (isBuoyant(thermal))
    {
        reading.select(defineBuoyancy(settings, thermal));
        wallPressure = settings.facts.get<WallConditions>().pressure;
        auto& reads = settings.ruleReads[Pressure::info.name];
        reads.push_back(stateField(Temperature{}));
        if (settings.multiphase()) reads.push_back(stateField(Phase{}));
    }
    settings.runningModels.push_back(running<HeatBalance>(mirrorsPairwise(geometry), wallPressure));
    if (std::ranges::any_of(thermal.kappa, [](double kappa) { return kappa > 0; }))
        settings.integration.factorsOfRunningModels.push_back(&StepFactors::diffusive);
}
}

const Model& thermalModel()
{
    static const Model model{
        "thermal",
        "heat conduction, walls that give heat, and buoyancy",
        read,
        {},
        {},
        prepare,
        {{"walls", [](const Settings& s) { return s.coefficients.has<ThermalProperties>() && s.has(entry::wallKind, "layers"); },
          "heat passes walls by ghosts that mirror the fluid (constant/thermophysicalProperties): take walls reflected"},
         {"integration",
          [](const Settings& s)
          { return !s.integration.moves && s.coefficients.has<ThermalProperties>() && isBuoyant(s.coefficients.of<ThermalProperties>()); },
          "quasiSteady leaves particles where they are, and a buoyant flow carries its heat: take a scheme that moves them"}},
        {},
        {{thermophysicalProperties, thermalEntries(), "heat; without the file there is none"}}};
    return model;
}

}
