#include "models/thermal/readThermal.hpp"
#include "base/words.hpp"
#include "models/scalarTransport/carriedScalar.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{
constexpr DimensionSet kelvin{0, 0, 0, 1}, watt = units::kg * units::m2 / units::s / units::s / units::s;
constexpr DimensionSet conductivity = watt / units::m / kelvin, heatCapacity = units::m2 / units::s / units::s / kelvin,
                       expansion = units::none / kelvin, heatFlux = watt / units::m2;
}

namespace entry
{
const FreeName kappa{"kappa", "number [W/(m K)], or a dictionary of one for each phase", "thermal conductivity, 0 or more"},
    Cp{"Cp", "number [J/(kg K)], or a dictionary of one for each phase", "specific heat capacity, above 0"},
    beta{"beta", "number [1/K], or a dictionary of one for each phase", "thermal expansion coefficient"},
    initial{"initial", "number or expression of $x $y $z [K], or a dictionary of one for each phase",
            "temperature where the time folder has no field T; default 0"},
    wall{"<wall>", "dictionary", "a wall of constant/geometry of that name, with T or q; nothing passes one with neither"};
const Choice type{"type",
                  {{"Boussinesq", "rho_0 (1 - beta (T - T0)) in the weight, rho_0 elsewhere"}},
                  required,
                  "how density depends on temperature"};
const Scalar T0{"T0", Unit{kelvin, "K"}, required, anyNumber, "temperature at which the density is that of constant/phaseProperties"},
    wallT{"T", Unit{kelvin, "K"}, notGiven, anyNumber, "temperature of the wall"},
    wallQ{"q", Unit{heatFlux, "W/m^2"}, notGiven, anyNumber, "heat flux of the wall into the fluid"};
const SubDictionary equationOfState{"equationOfState", notGiven, "buoyancy; without it heat does not act upon the flow"},
    walls{"walls", notGiven, "temperature or heat flux of walls; nothing passes those that are left out"};
}

EntryList thermalEntries()
{
    return {entry::kappa,
            entry::Cp,
            entry::initial,
            {entry::equationOfState, {entry::type, entry::beta, entry::T0}},
            {entry::walls, {{entry::wall, {entry::wallT, entry::wallQ}}}}};
}

namespace
{
auto readKappa(const Dictionary& d, const std::string& key)
{
    const double kappa = d.get(key, conductivity);
    if (kappa < 0) d.error(key, fmt::format("a conductivity is 0 or more [W/(m K)], not {:.6g}", kappa));
    return std::max(0.0, kappa);
}

auto readCp(const Dictionary& d, const std::string& key)
{
    const double Cp = d.get(key, heatCapacity);
    if (Cp > 0) return Cp;
    d.error(key, fmt::format("a specific heat capacity is above 0 [J/(kg K)], not {:.6g}", Cp));
    return 1.0;
}

auto readBeta(const Dictionary& d, const std::string& key) { return d.get(key, expansion); }

void readBoussinesq(const Reading& reading, const Dictionary& dict, ThermalProperties& thermal)
{
    const auto& phases = reading.settings.coefficients.phases;
    thermal.beta.assign(phases.size(), 0);
    if (!entry::equationOfState.given(dict)) return;
    const auto d = entry::equationOfState(dict);
    if (!entry::type.known(d)) return;
    thermal.beta = ofPhases<double>(d, entry::beta.keyword(), phases, readBeta);
    thermal.T0 = entry::T0(d);
    if (!reading.settings.hasGravity()) entry::beta.error(d, "does nothing without gravity: give constant/g, or leave equationOfState out");
}

std::vector<HeatAtWall> readWalls(const Reading& reading, const Dictionary& dict, const std::vector<double>& kappa)
{
    std::vector<HeatAtWall> heats;
    std::vector<std::string> names;
    for (const auto& wall : reading.geometry.walls)
    {
        names.push_back(wall.name);
        heats.push_back({wall.name, {}, {}});
    }
    const auto walls = entry::walls(dict);
    for (const auto& key : walls.keys())
    {
        const auto found = std::find(names.begin(), names.end(), key);
        if (!walls.isDictionary(key))
        {
            walls.error(key, fmt::format("wall \"{0}\" must be a dictionary: {0} {{ T 300; }}, or {0} {{ q 100; }}", key));
            continue;
        }
        const auto d = walls.subDict(key);
        HeatAtWall heat{key, entry::wallT.ifGiven(d), entry::wallQ.ifGiven(d)};
        if (found != names.end()) heats[std::size_t(found - names.begin())] = heat;
        else if (names.empty()) walls.error(key, "there are no walls in constant/geometry");
        else walls.error(key, fmt::format("wall \"{}\" is unknown. {}", key, suggestion(key, "walls", names)));
        if (heat.T && heat.q) entry::wallQ.error(d, "the wall has a temperature T already: give one of the two");
        if (heat.q && std::ranges::find(kappa, 0.0) != kappa.end())
            entry::wallQ.error(d, "a heat flux needs a conductivity kappa above 0 of all phases");
    }
    return heats;
}
}

ThermalProperties readThermal(const Reading& reading)
{
    const auto dict = reading.theCase.dictionary(thermophysicalProperties);
    const auto& phases = reading.settings.coefficients.phases;
    ThermalProperties thermal;
    thermal.kappa = ofPhases<double>(dict, entry::kappa.keyword(), phases, readKappa);
    thermal.Cp = ofPhases<double>(dict, entry::Cp.keyword(), phases, readCp);
    thermal.initial = readInitial(dict, phases);
    readBoussinesq(reading, dict, thermal);
    thermal.walls = readWalls(reading, dict, thermal.kappa);
    dict.reportUnused();
    return thermal;
}

}
