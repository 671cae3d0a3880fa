#include "solver/outliers.hpp"
#include "case/labelEntries.hpp"
#include "parallel/reduce.hpp"
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sph
{

namespace
{
NamedParticle named(const AnySimulation& simulation, std::size_t i)
{
    const auto x = simulation.positions(), phase = simulation.field(Phase::info.name);
    const double* const label = simulation.field(origId).component[0];
    const auto of = [i](const double* a) { return a ? a[i] : 0.0; };
    return {i,
            std::size_t(of(phase.component[0])),
            {of(x.component[0]), of(x.component[1]), of(x.component[2])},
            label ? std::optional(label[i]) : std::nullopt,
            ranks() ? ranks()->rank() : 0};
}

Outlier outlier(const AnySimulation& simulation, const std::string& field, double value, std::size_t i)
{
    return {named(simulation, i), field, value};
}
}

std::string NamedParticle::inWords() const
{
    return fmt::format("particle {}{}{} at ({:.6g} {:.6g} {:.6g})", particle, ranks() ? fmt::format(" of rank {}", rank) : "",
                       label ? fmt::format(" (origId {:.0f})", *label) : "", position.x, position.y, position.z);
}

std::optional<Outlier> notFinite(const AnySimulation& simulation)
{
    auto all = simulation.fields();
    all.insert(all.begin(), simulation.positions());
    for (const auto& field : all)
        for (const double* values : field.component)
            for (std::size_t i = 0; values && i < simulation.size(); ++i)
                if (!std::isfinite(values[i])) return outlier(simulation, field.name, values[i], i);
    return {};
}

std::optional<Outlier> impossibleDensity(const AnySimulation& simulation, const std::vector<double>& restDensity)
{
    const double *rho = simulation.field(Density::info.name).component[0], *phase = simulation.field(Phase::info.name).component[0],
                 *holder = simulation.field(Holder::info.name).component[0];
    std::size_t furthest = 0;
    double most = 0;
    for (std::size_t i = 0; i < simulation.size(); ++i)
    {
        if (holder && holder[i] > 0) continue;
        const double ratio = rho[i] / restDensity[phase ? std::size_t(phase[i]) : 0];
        if (ratio >= leastCompression && ratio <= mostCompression) continue;
        const double off = ratio > 0 ? std::fabs(std::log(ratio)) : std::numeric_limits<double>::infinity();
        if (most > 0 && !(off > most)) continue;
        most = off;
        furthest = i;
    }
    if (!(most > 0)) return {};
    return outlier(simulation, Density::info.name, rho[furthest], furthest);
}

std::optional<Outlier> binding(const AnySimulation& simulation, const StepLimit& limit)
{
    if (!limit.field) return {};
    const auto values = simulation.field(limit.field->name);
    struct Largest
    {
        double square = 0;
        NamedParticle particle;
    } largest;
    std::size_t where = 0;
    for (std::size_t i = 0; values.component[0] && i < simulation.size(); ++i)
    {
        double square = 0;
        for (const double* component : values.component)
            if (component) square += sqr(component[i]);
        if (!(square > largest.square)) continue;
        largest.square = square;
        where = i;
    }
    if (largest.square > 0) largest.particle = named(simulation, where);
    largest = ofAllRanks(largest, Largest{},
                         [](Largest& most, const Largest& next)
                         {
                             if (next.square > most.square) most = next;
                         });
    if (!(largest.square > 0)) return {};
    return Outlier{largest.particle, limit.field->name, std::sqrt(largest.square)};
}

}
