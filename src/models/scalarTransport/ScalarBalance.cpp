#include "models/scalarTransport/ScalarBalance.hpp"
#include "models/scalarTransport/scalarFluxTerm.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{
std::string startOf(const std::string& name) { return "scalarStart_" + name; }

/// [m^2/s]
double largestDiffusivity(const TransportedScalar& scalar, const Coefficients& c)
{
    const auto k = pairDiffusivities(scalar, c);
    const std::size_t phases = c.phases.size();
    double largest = 0;
    for (std::size_t a = 0; a < phases; ++a)
        for (std::size_t b = 0; b < phases; ++b)
            largest = std::max(largest, k[a * phases + b] / std::min(c.restDensity[a], c.restDensity[b]));
    return largest;
}
}

template<int dim>
ScalarBalance<dim>::ScalarBalance(Particles<dim>& particles, const Numbers& restored, const std::vector<TransportedScalar>& scalars)
{
    const auto& c = particles.coefficients();
    const auto& integration = particles.settings().integration;
    for (const auto& scalar : scalars)
    {
        names_.push_back(scalar.name);
        if (const auto found = restored.find(startOf(scalar.name)); found != restored.end()) start_[scalar.name] = found->second;
        if (const double D = largestDiffusivity(scalar, c); D > 0)
            limits_.push_back({integration.maxSubSteps * (integration.factors.diffusive * sqr(0.5 * c.support) / D),
                               "diffusion of " + scalar.name, true});
    }
}

template<int dim> typename ScalarBalance<dim>::Held ScalarBalance<dim>::held(const Particles<dim>& particles, const std::string& name) const
{
    const auto n = particles.size();
    if (particles.total() == 0) return {};
    const double *c = particles.store().component(name, 0), *m = particles.store().component(Mass::info.name, 0);
    const auto value = [c](std::size_t i) { return c[i]; };
    return {least(n, value), most(n, value), sum(n, [&](std::size_t i) { return m[i] * c[i]; }),
            sum(n, [&](std::size_t i) { return m[i] * std::abs(c[i]); })};
}

/// Change since the first start, relative to sum m |c|: there are scalars whose sum is 0.
template<int dim> double ScalarBalance<dim>::change(const std::string& name, const Held& now) const
{
    const auto start = start_.find(name);
    return start != start_.end() && now.size > 0 ? (now.amount - start->second) / now.size : 0;
}

template<int dim> std::vector<Stage<dim>> ScalarBalance<dim>::stages(JoinPoint place)
{
    if (place != JoinPoint::complete) return {};
    return {{"amounts of scalars", "sum m c at the first start, which changes are of",
             [this](Particles<dim>& particles, const Substep&)
             {
                 for (const auto& name : names_)
                     if (!start_.contains(name)) start_[name] = held(particles, name).amount;
             }}};
}

template<int dim> Numbers ScalarBalance<dim>::columns(const Particles<dim>& particles) const
{
    Numbers columns;
    for (const auto& name : names_)
    {
        const auto now = held(particles, name);
        columns.merge(Numbers{{"min(" + name + ")", now.least},
                              {"max(" + name + ")", now.most},
                              {"amount(" + name + ")", now.amount},
                              {"change(" + name + ")", change(name, now)}});
    }
    return columns;
}

template<int dim> std::string ScalarBalance<dim>::report(const Particles<dim>& particles) const
{
    std::string lines;
    const bool keeps = !particles.holdsAny();
    for (const auto& name : names_)
    {
        const auto now = held(particles, name);
        lines += fmt::format("{}: {:.6g} .. {:.6g}, amount {:.15g} kg{}\n", name, now.least, now.most, now.amount,
                             keeps ? fmt::format(", changed by {:.2g}", change(name, now)) : "");
    }
    return lines;
}

template<int dim> void ScalarBalance<dim>::save(Numbers& numbers) const
{
    for (const auto& [name, amount] : start_) numbers[startOf(name)] = amount;
}

template class ScalarBalance<2>;
template class ScalarBalance<3>;

}
