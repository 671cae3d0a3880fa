#include "models/soil/readPoreWater.hpp"
#include "base/words.hpp"
#include "geometry/wallNames.hpp"
#include "kernels/overLattice.hpp"
#include "models/soil/PoreWaterStep.hpp"
#include "models/soil/Seepage.hpp"
#include "models/soil/SoilFields.hpp"
#include "operators/BalancedGradient.hpp"
#include "soilLaws/soilLaws.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

namespace sph
{

namespace entry
{
const SubDictionary poreWater{poreWaterKeyword, notGiven, "water that fills the pores; without it the soil is dry, or drained"};
const Scalar permeability{"permeability", units::mPerS, required, nonNegative,
                          "k of Darcy's law, for water of this density under 9.81 m/s^2; 0: undrained"},
    porosity{"porosity", units::none, required, positiveBelow(1), "share of the pores in the volume"},
    bulkModulus{"bulkModulus", units::pressure, 2.2e9, positive, "of the water; 2.2e9 without air, far less with bubbles"},
    waterDensity{"density", units::density, 1000, positive, "of the water; that of the soil, `rho`, is with its water"},
    waterTolerance{"tolerance", units::none, 1e-6, positiveBelow(1), "residual of the solve over that at its start"},
    wallPorePressure{"porePressure", units::pressure, notGiven, anyNumber, "pressure at a wall that drains"},
    wallFlux{"flux", units::mPerS, notGiven, anyNumber, "what a wall lets into the soil, per area"},
    startPressure{"pressure", units::pressure, required, anyNumber, "the same everywhere"},
    waterTable{"waterTable", units::m, required, anyNumber,
               "height, against gravity, from the origin, of p = 0; above it p is 0, too, and negative with unsaturated"},
    capillaryHead{"capillaryHead", units::m, required, positive, "height above the water table over which pores drain"},
    specificYield{"specificYield", units::none, required, positiveBelow(1), "share of the volume that drains there, at most the porosity"},
    leastRelativePermeability{"leastRelativePermeability", units::none, 1e-3, positiveBelow(1),
                              "permeability of drained pores over that of full ones"};
const Text waterLevel{"waterLevel", notGiven,
                      "height [m] of water that stands on free surfaces, against gravity, from the origin: a number, or an expression of "
                      "`$t` [s]: \"8 - 0.1*$t\""},
    wallLevel{"waterLevel", notGiven,
              "height [m] of water that stands behind the wall, as a number or an expression of `$t`; nothing passes above it"};
const SubDictionary unsaturated{"unsaturated", notGiven, "pores drain above the water table, and suction does not act on the grains"};
const Count waterIterations{"maxIter", 1000, atLeast(1), "iterations of the solve at most"};
const Choice freeSurface{"freeSurface",
                         {{"drained", "p = 0 on them"}, {"closed", "nothing passes, as through a membrane"}},
                         "drained",
                         "what free surfaces do to the water"};
const Choice projection{
    "projection",
    {{"laplacian", "by a Laplacian: not within two rows of a free surface that is closed"},
     {"exact", "by the divergence of the forces, with `stressDivergence balanced`: for undrained soil, two passes an iteration"}},
    "laplacian",
    "how the water foresees what its pressure does to the grains"};
const SubDictionary waterWalls{"walls", notGiven, "pressure or flux at walls; nothing passes those that are left out"},
    waterInitial{"initial", byScene("the field porePressure of the time folder, else 0"),
                 "pore pressure at the start where there is no field of it"};
const FreeName waterWall{"<wall>", "dictionary", "a wall of constant/geometry of that name, with porePressure, waterLevel or flux"};

Cases initialWaterCases()
{
    return {{{"uniform", "the same everywhere"}, {startPressure}}, {{"hydrostatic", "at rest below a water table"}, {waterTable}}};
}
const Choice waterStart{"type", wordsOf(initialWaterCases()), required, "what it is"};
}

ListedEntry poreWaterEntries()
{
    return {entry::poreWater,
            {entry::permeability,
             entry::porosity,
             entry::bulkModulus,
             entry::waterDensity,
             entry::freeSurface,
             entry::projection,
             entry::waterLevel,
             {entry::unsaturated, {entry::capillaryHead, entry::specificYield, entry::leastRelativePermeability}},
             {entry::waterWalls, {{entry::waterWall, {entry::wallPorePressure, entry::wallLevel, entry::wallFlux}}}},
             {entry::waterInitial, {{entry::waterStart, entry::initialWaterCases()}}},
             entry::waterTolerance,
             entry::waterIterations}};
}

namespace
{
std::optional<WaterLevel> readLevel(const Dictionary& d, const Text& level, Vector<3> g)
{
    const auto text = level.ifGiven(d);
    if (!text) return {};
    if (!(mag(g) > 0)) level.error(d, "a level of water needs gravity, `value` of constant/g");
    WaterLevel read{*text};
    try
    {
        read.now = read.at(0);
    }
    catch (const ExpressionError& e)
    {
        level.error(d, fmt::format("\"{}\": {}", *text, e.what()));
    }
    return read;
}

std::optional<Retention> readRetention(const Dictionary& d, double porosity, Vector<3> g)
{
    if (!entry::unsaturated.given(d)) return {};
    const auto of = entry::unsaturated(d);
    const Retention read{entry::capillaryHead.needed(of), entry::specificYield.needed(of), entry::leastRelativePermeability(of)};
    if (!(mag(g) > 0)) entry::unsaturated.error(d, "there is no water table without gravity, `value` of constant/g");
    if (entry::specificYield.given(of) && read.specificYield > porosity)
        entry::specificYield.error(of, fmt::format("{:.6g} is more than the porosity, {:.6g}", read.specificYield, porosity));
    return read;
}

std::vector<WaterAtWall> readWalls(const Dictionary& d, const Geometry& geometry, double permeability, Vector<3> g)
{
    std::vector<WaterAtWall> all(geometry.walls.size());
    const auto names = wallNames(geometry);
    const auto walls = entry::waterWalls(d);
    for (const auto& name : walls.keys())
    {
        if (!walls.isDictionary(name))
        {
            walls.error(
                name,
                fmt::format("wall \"{0}\" must be a dictionary: {0} {{ porePressure 0; }}, {0} {{ waterLevel 8; }} or {0} {{ flux 1e-6; }}",
                            name));
            continue;
        }
        const auto of = walls.subDict(name);
        const auto pressure = entry::wallPorePressure.ifGiven(of), flux = entry::wallFlux.ifGiven(of);
        const auto level = readLevel(of, entry::wallLevel, g);
        if (pressure && flux) entry::wallFlux.error(of, "the wall has a porePressure already: give one of the two");
        if (level && (pressure || flux)) entry::wallLevel.error(of, "the wall has a porePressure or a flux already: give one of them");
        if (flux && !(permeability > 0)) entry::wallFlux.error(of, "a flux needs a permeability above 0");
        const auto found = std::ranges::find(names, name);
        if (found != names.end()) all[std::size_t(found - names.begin())] = {pressure, level, flux.value_or(0)};
        else if (names.empty()) walls.error(name, "there are no walls in constant/geometry");
        else walls.error(name, fmt::format("wall \"{}\" is unknown. {}", name, suggestion(name, "walls", names)));
    }
    return all;
}

template<int dim> LatticeSums sumsOnLattice(const Resolution& resolution)
{
    const Kernel<dim> kernel(resolution.kernel, resolution.H());
    const double dx = resolution.spacing, volume = std::pow(dx, dim);
    LatticeSums lattice{.spacing = dx, .secondMoment = volume * momentOnLattice(kernel, dx)};
    const int reach = int(std::ceil(resolution.support)), ofDepth = dim == 3 ? reach : 0;
    std::vector<double> above(std::size_t(reach) + 1); // of the plane so many rows up
    for (int up = 1; up <= reach; ++up)
        for (int a = -reach; a <= reach; ++a)
            for (int b = -ofDepth; b <= ofDepth; ++b)
                above[std::size_t(up)] -= volume * kernel.dWdrOverR(dx * std::sqrt(double(up * up + a * a + b * b))) * up * dx;
    double slopes = 0;
    for (int a = -reach; a <= reach; ++a)
        for (int b = -reach; b <= reach; ++b)
            for (int c = -ofDepth; c <= ofDepth; ++c)
                if (a != 0 || b != 0 || c != 0) slopes -= kernel.dWdrOverR(dx * std::sqrt(double(a * a + b * b + c * c)));
    lattice.weight = 2 * volume * slopes / lattice.secondMoment;
    for (int row = 0; row < std::min(reach, int(lattice.m_1.size())); ++row)
    {
        const double missing = std::accumulate(above.begin() + row + 1, above.end(), 0.0);
        if (!(missing > 0)) break;
        lattice.m_1[std::size_t(lattice.rows++)] = missing;
    }
    return lattice;
}

InitialPorePressure readInitial(const Dictionary& d, const PoreWater& water, Vector<3> g)
{
    if (!entry::waterInitial.given(d)) return [](Vector<3>) { return 0.0; };
    const auto initial = entry::waterInitial(d);
    const auto type = entry::waterStart.known(initial);
    if (type && *type == "hydrostatic")
    {
        const double table = entry::waterTable.needed(initial);
        if (!(mag(g) > 0)) entry::waterStart.error(initial, "hydrostatic needs gravity, `value` of constant/g");
        return [=, rho = water.density, least = water.unsaturated ? -HUGE_VAL : 0.0](Vector<3> x)
        { return rho * std::fmax(least, dot(g, x) + mag(g) * table); };
    }
    const double p = type ? entry::startPressure.needed(initial) : 0;
    return [=](Vector<3>) { return p; };
}

Evolving porePressureOf(const InitialPorePressure& initial)
{
    Evolving p{.value = stateField(PorePressure{}), .advancedByModel = true, .ofMaterial = true};
    p.missing = [=](const Loading& loading)
    {
        if (loading.restarted)
            throw CaseError("the time folder that the run goes on from has no field porePressure: the water in the pores is lost");
        for (std::size_t i = 0; i < loading.size(); ++i)
            loading.values[0][i] = initial({loading.cloud.x[i], loading.cloud.y[i], loading.cloud.z[i]});
    };
    p.check = [](const Loading& loading)
    {
        for (std::size_t i = 0; i < loading.size(); ++i)
            if (!std::isfinite(loading.values[0][i]))
                throw CaseError(fmt::format("{} has a pore pressure of {} Pa", loading.cloud.particle(i), loading.values[0][i]));
    };
    return p;
}
}

InitialPorePressure readPoreWater(const Reading& reading, const Dictionary& ofSoil)
{
    if (!entry::poreWater.given(ofSoil)) return nullptr;
    auto& settings = reading.settings;
    const auto d = entry::poreWater(ofSoil);
    PoreWater water;
    water.permeability = entry::permeability(d);
    water.porosity = entry::porosity(d);
    water.bulkModulus = entry::bulkModulus(d);
    water.density = entry::waterDensity(d);
    water.surfaceDrains = entry::freeSurface(d) == "drained";
    water.projects = entry::projection(d) == "exact";
    water.tolerance = entry::waterTolerance(d);
    water.maxIter = entry::waterIterations(d);
    water.walls = readWalls(d, reading.geometry, water.permeability, settings.coefficients.g);
    water.level = readLevel(d, entry::waterLevel, settings.coefficients.g);
    water.unsaturated = readRetention(d, water.porosity, settings.coefficients.g);
    water.lattice = settings.coefficients.dimension == 2 ? sumsOnLattice<2>(settings.resolution) : sumsOnLattice<3>(settings.resolution);
    const bool drains =
        water.surfaceDrains || std::ranges::any_of(water.walls, [](const auto& wall) { return wall.pressure || wall.level; });
    if (water.permeability > 0 && !drains)
        entry::permeability.error(d, "no boundary drains, so that the water has nowhere to go: give a wall a porePressure in `walls`, take "
                                     "`freeSurface drained;`, or `permeability 0;` for undrained soil");
    const auto initial = readInitial(d, water, settings.coefficients.g);
    settings.state.push_back(porePressureOf(initial));
    settings.coefficients.set(std::move(water));
    return initial;
}

void selectPoreWater(const Reading& reading, const std::vector<std::string>& force, bool showsVelocity)
{
    auto& settings = reading.settings;
    settings.groups.push_back({.name = ofPoreForce,
                               .terms = force,
                               .changed = {PoreStress::info.name},
                               .names = {{Acceleration::info.name, poreAcceleration}},
                               .inputs = {PoreStress::info.name}});
    const auto& water = settings.coefficients.of<PoreWater>();
    if (water.level) reading.select(LiftOfOuterWater::name);
    settings.groups.push_back({.name = ofSeepage, .terms = {water.unsaturated ? UnsaturatedSeepage::name : Seepage::name}});
    if (showsVelocity) settings.groups.back().terms.emplace_back(DarcyVelocity::name);
    if (water.sumsChange())
        settings.groups.push_back({.name = ofSeepageChange,
                                   .terms = {water.unsaturated ? UnsaturatedSeepageOfChange::name : SeepageOfChange::name},
                                   .changed = {PorePressureChange::info.name},
                                   .inputs = {PorePressureChange::info.name},
                                   .repeats = true});
    if (water.projects)
        settings.groups.push_back({.name = ofDivergence,
                                   .terms = {BalancedDivergenceOfChange::name},
                                   .changed = {VelocityChange::info.name},
                                   .inputs = {VelocityChange::info.name},
                                   .repeats = true});
    settings.runningModels.push_back(running<PoreWaterStep>());
}

}
