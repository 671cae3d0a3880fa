#include "models/scalarTransport/scalarFluxTerm.hpp"
#include "models/scalarTransport/ScalarFlux.hpp"

namespace sph
{

std::vector<double> harmonicMeans(const std::vector<double>& k)
{
    std::vector<double> means;
    for (const double k_a : k)
        for (const double k_b : k) means.push_back(k_a > 0 && k_b > 0 ? 2 * k_a * k_b / (k_a + k_b) : 0);
    return means;
}

std::vector<double> pairDiffusivities(const TransportedScalar& scalar, const Coefficients& c)
{
    auto k = scalar.diffusivity;
    for (std::size_t a = 0; a < k.size(); ++a) k[a] *= c.restDensity[a];
    return harmonicMeans(k);
}

namespace
{
/// Arrays that the terms of a scalar point to.
struct Tables
{
    std::vector<double> k, share{1}, sign{1}, offset{0};
};
}

std::string defineScalarFlux(Settings& settings, const TransportedScalar& scalar, bool walls, bool evenAtWalls)
{
    auto made = std::make_shared<Tables>();
    made->k = pairDiffusivities(scalar, settings.coefficients);
    for (const auto& value : scalar.wallValue)
    {
        made->share.push_back(value || evenAtWalls);
        made->sign.push_back(value ? -1 : 1);
        made->offset.push_back(2 * value.value_or(0));
    }
    const std::shared_ptr<const Tables> tables = made;
    const int phases = int(settings.coefficients.phases.size());
    const std::string term = "diffusion of " + scalar.name;
    const auto define = [&]<class Diffusivity, class Walls>(const Diffusivity& diffusivity, const Walls& atWalls)
    {
        using Flux = ScalarFlux<Diffusivity, Walls>;
        settings.define<Flux>(term, [tables, flux = Flux{diffusivity, atWalls}](const Coefficients&) { return flux; },
                              {{ScalarValue::info.name, scalar.name}, {ScalarRate::info.name, scalar.rateName()}});
    };
    const auto withWalls = [&](const auto& diffusivity)
    {
        if (walls) define(diffusivity, ScalarAtWalls{tables->share.data(), tables->sign.data(), tables->offset.data()});
        else define(diffusivity, NoWalls{});
    };
    if (phases > 1) withWalls(DiffusivityOfPhases{tables->k.data(), phases});
    else withWalls(UniformDiffusivity{tables->k[0]});
    return term;
}

}
