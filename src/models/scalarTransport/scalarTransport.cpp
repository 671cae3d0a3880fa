#include "models/scalarTransport/scalarTransport.hpp"
#include "models/scalarTransport/ScalarBalance.hpp"
#include "models/scalarTransport/carriedScalar.hpp"
#include "models/scalarTransport/mirrorsPairwise.hpp"
#include "models/scalarTransport/readScalars.hpp"
#include "models/scalarTransport/scalarFluxTerm.hpp"
#include <algorithm>

namespace sph
{

namespace
{
Evolving evolving(const TransportedScalar& scalar)
{
    auto c = carriedScalar(stateField(ScalarValue{}, scalar.name), stateField(ScalarRate{}, scalar.rateName()), scalar.initial,
                           "constant/scalarTransport");
    c.amount = scalar.name;
    return c;
}

void prepare(const Reading& reading)
{
    auto& settings = reading.settings;
    auto scalars = readScalars(reading);
    if (scalars.empty()) return;
    for (const auto& scalar : scalars) settings.state.push_back(evolving(scalar));
    settings.coefficients.set(std::move(scalars));
}

void read(const Reading& reading)
{
    auto& settings = reading.settings;
    if (!settings.coefficients.has<std::vector<TransportedScalar>>()) return;
    const auto scalars = settings.coefficients.of<std::vector<TransportedScalar>>();
    const bool walls = !reading.geometry.patches.empty() || !reading.geometry.layers.empty(), even = mirrorsPairwise(reading.geometry);
    for (const auto& scalar : scalars) reading.select(defineScalarFlux(settings, scalar, walls, even));
    settings.runningModels.push_back(running<ScalarBalance>(scalars));
    const bool diffuses = std::ranges::any_of(scalars, [](const auto& scalar)
                                              { return std::ranges::any_of(scalar.diffusivity, [](double D) { return D > 0; }); });
    if (diffuses) settings.integration.factorsOfRunningModels.push_back(&StepFactors::diffusive);
}
}

const Model& scalarTransportModel()
{
    static const Model model{"scalarTransport",
                             "dilute scalars that ride on the particles and diffuse between them",
                             read,
                             {},
                             {},
                             prepare,
                             {},
                             {},
                             {{"constant/scalarTransport", scalarEntries(), "dilute scalars; without the file there are none"}}};
    return model;
}

}
