#include "scalarTransport.hpp"
#include "ScalarBalance.hpp"
#include "positionExpression.hpp"
#include "readScalars.hpp"
#include "scalarFluxTerm.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace
{
/// Whether mirroring is the same from both sides of a pair: planes alone, parallel or at right angles.
bool mirrorsPairwise(const Geometry& geometry)
{
    if (!geometry.layers.empty()) return false;
    std::vector<Vector<3>> normals;
    for (const auto& patch : geometry.patches)
    {
        if (patch.shape->smallestRadius() < std::numeric_limits<double>::infinity() || patch.shape->hasEdges()) return false;
        normals.push_back(patch.shape->foot({}).normal);
    }
    const double roundOff = 1e-12;
    for (const auto& a : normals)
        for (const auto& b : normals)
            if (const double along = std::abs(dot(a, b)); along > roundOff && along < 1 - roundOff) return false;
    return true;
}

Evolving evolving(const TransportedScalar& scalar)
{
    Evolving c{stateField(ScalarValue{}, scalar.name), stateField(ScalarRate{}, scalar.rateName())};
    c.amount = scalar.name;
    c.missing = [initial = scalar.initial, name = scalar.name](const Loading& loading)
    {
        for (std::size_t i = 0; i < loading.size(); ++i) try
            {
                const Vector<3> x{loading.cloud.x[i], loading.cloud.y[i], loading.cloud.z[i]};
                loading.values[0][i] = evaluateAt(initial[loading.phaseOf(i)], x).scalar;
            }
            catch (const ExpressionError& e)
            {
                throw CaseError({"constant/scalarTransport", 0},
                                fmt::format("`initial` of {}, {}: {}", name, loading.cloud.particle(i), e.what()));
            }
    };
    c.check = [name = scalar.name](const Loading& loading)
    {
        for (std::size_t i = 0; i < loading.size(); ++i)
            if (!std::isfinite(loading.values[0][i]))
                throw CaseError(fmt::format("{} has {} {}", loading.cloud.particle(i), name, loading.values[0][i]));
    };
    c.inlet = [name = scalar.name](const Dictionary& d, std::size_t) { return d.get(name, units::none); };
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
    settings.parts.push_back(partOf<ScalarBalance>(scalars));
    const bool diffuses = std::ranges::any_of(scalars, [](const auto& scalar)
                                              { return std::ranges::any_of(scalar.diffusivity, [](double D) { return D > 0; }); });
    if (diffuses) settings.integration.factorsOfParts.push_back(&StepFactors::diffusive);
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
