#include "models/thermal/thermalTerms.hpp"
#include "models/scalarTransport/scalarFluxTerm.hpp"
#include "models/thermal/Buoyancy.hpp"
#include "models/thermal/HeatFlux.hpp"

namespace sph
{

std::vector<double> pairConductivitiesOverCp(const ThermalProperties& thermal)
{
    auto k = harmonicMeans(thermal.kappa);
    const auto phases = thermal.kappa.size();
    for (std::size_t n = 0; n < k.size(); ++n) k[n] /= thermal.Cp[n / phases];
    return k;
}

namespace
{
/// Arrays that a term points to: of pairs of phases, and of the places of a ghost.
struct Tables
{
    std::vector<double> k, share;
};

void defineFlux(Settings& settings, const std::string& term, const std::string& rate, std::vector<double> k, std::vector<double> share)
{
    const std::shared_ptr<const Tables> tables = std::make_shared<Tables>(Tables{std::move(k), std::move(share)});
    const int phases = int(settings.coefficients.phases.size());
    const auto define = [&]<class Conductivity, class Walls>(const Conductivity& conductivity, const Walls& walls)
    {
        using Flux = ScalarFlux<Conductivity, Walls>;
        settings.define<Flux>(term, [tables, flux = Flux{conductivity, walls}](const Coefficients&) { return flux; },
                              {{ScalarRate::info.name, rate}});
    };
    const auto withWalls = [&](const auto& conductivity)
    {
        if (tables->share.empty()) define(conductivity, TemperatureDifference{});
        else define(conductivity, TemperatureDifferenceByWall{tables->share.data()});
    };
    if (phases > 1) withWalls(DiffusivityOfPhases{tables->k.data(), phases});
    else withWalls(UniformDiffusivity{tables->k[0]});
}
}

std::vector<std::string> defineConduction(Settings& settings, const ThermalProperties& thermal, bool byWall)
{
    std::vector<std::string> terms{"conduction"};
    const std::size_t walls = thermal.walls.size();
    std::vector<double> share;
    if (byWall) share.assign(walls + 2, 1);
    if (byWall) share.back() = 0;
    defineFlux(settings, terms[0], TemperatureRate::info.name, pairConductivitiesOverCp(thermal), share);
    for (std::size_t w = 0; w < walls; ++w)
    {
        const auto& wall = thermal.walls[w];
        if (!wall.passes()) continue;
        std::vector<double> ofWall(walls + 2, 0);
        ofWall[1 + w] = 1;
        terms.push_back("heat from " + wall.name);
        defineFlux(settings, terms.back(), wall.rateName(), harmonicMeans(thermal.kappa), ofWall);
    }
    return terms;
}

std::string defineBuoyancy(Settings& settings, const ThermalProperties& thermal)
{
    const auto define = [&]<class Expansion>(const auto& make)
    {
        using Force = Buoyancy<Expansion>;
        settings.define<Force>(
            Force::name,
            [make, T0 = thermal.T0](const Coefficients& c) {
                return Force{make(), T0, c.g};
            },
            settings.separateSums);
        return Force::name;
    };
    const auto beta = std::make_shared<const std::vector<double>>(thermal.beta);
    if (settings.multiphase()) return define.operator()<ExpansionOfPhases>([beta] { return ExpansionOfPhases{beta->data()}; });
    return define.operator()<UniformExpansion>([beta] { return UniformExpansion{(*beta)[0]}; });
}

}
