#include "models/thermal/HeatBalance.hpp"
#include "geometry/components.hpp"
#include "models/thermal/thermalRules.hpp"
#include "models/thermal/thermalTerms.hpp"
#include "parallel/reduce.hpp"
#include <algorithm>
#include <cctype>
#include <cmath>
#include <fmt/format.h>

namespace sph
{

namespace
{
constexpr const char* heatAtStart = "heatStart";
double plain(double T) { return T; }
double size(double T) { return std::abs(T); }

/// [m^2/s]
double largestDiffusivity(const ThermalProperties& thermal, const Coefficients& c)
{
    const auto k = pairConductivitiesOverCp(thermal);
    double largest = 0;
    for (std::size_t n = 0; n < k.size(); ++n) largest = std::max(largest, k[n] / c.restDensity[n / c.phases.size()]);
    return largest;
}
}

template<int dim>
HeatBalance<dim>::HeatBalance(Particles<dim>& particles, const Numbers& restored, bool even, const std::string& wallPressure)
    : thermal_(particles.coefficients().template of<ThermalProperties>())
{
    const auto& c = particles.coefficients();
    const auto& integration = particles.settings().integration;
    if (const auto found = restored.find(heatAtStart); found != restored.end()) start_ = found->second;
    if (const double a = largestDiffusivity(thermal_, c); a > 0)
        limits_.push_back({integration.maxSubSteps * (integration.factors.diffusive * sqr(0.5 * c.support) / a), "conduction", true});
    auto& images = particles.images();
    auto& store = particles.store();
    if (particles.geometry().patches.empty()) return;
    images.rules().set(Temperature{}, std::make_unique<ContinuedTemperature<dim>>(thermal_, store));
    images.rules().set(HeatedWall{}, std::make_unique<HeatedWallOfGhost<dim>>(thermal_, even));
    const auto buoyant = [&](std::unique_ptr<GhostPressure<dim>> ofWeight)
    { images.rules().set(Pressure{}, std::make_unique<BuoyantPressure<dim>>(thermal_, store, c.g, std::move(ofWeight))); };
    if (wallPressure == "hydrostatic") buoyant(std::make_unique<HydrostaticPressure<dim>>(store, c));
    else if (wallPressure == "detaching") buoyant(std::make_unique<DetachingPressure<dim>>(store, c));
}

template<int dim> auto HeatBalance<dim>::ofPhase(const Particles<dim>& particles, const std::vector<double>& values) const
{
    const auto& store = particles.store();
    return [&values, phase = store.has(Phase{}) ? store.component(Phase::info.name, 0) : nullptr](std::size_t i)
    { return values[phase ? std::size_t(phase[i]) : 0]; };
}

template<int dim> double HeatBalance<dim>::heat(const Particles<dim>& particles, double (*f)(double)) const
{
    const double *T = particles.store().component(Temperature::info.name, 0), *m = particles.store().component(Mass::info.name, 0);
    return sum(particles.size(), [&, Cp = ofPhase(particles, thermal_.Cp)](std::size_t i) { return m[i] * Cp(i) * f(T[i]); });
}

template<int dim> double HeatBalance<dim>::convection(const Particles<dim>& particles, int c) const
{
    const auto& store = particles.store();
    const double *T = store.component(Temperature::info.name, 0), *m = store.component(Mass::info.name, 0),
                 *v = store.component(Velocity::info.name, c);
    return sum(particles.size(),
               [&, Cp = ofPhase(particles, thermal_.Cp)](std::size_t i) { return m[i] * Cp(i) * (T[i] - thermal_.T0) * v[i]; });
}

template<int dim> double HeatBalance<dim>::total(const Particles<dim>& particles, const std::string& field) const
{
    const auto& store = particles.store();
    const double *q = store.component(field, 0), *m = store.component(Mass::info.name, 0);
    return sum(particles.size(), [&](std::size_t i) { return m[i] * q[i]; });
}

template<int dim> Numbers HeatBalance<dim>::columns(const Particles<dim>& particles) const
{
    if (particles.total() == 0) return {};
    const auto n = particles.size();
    const auto value = [T = particles.store().component(Temperature::info.name, 0)](std::size_t i) { return T[i]; };
    const double now = heat(particles, plain), scale = heat(particles, size);
    Numbers columns{{"min(T)", least(n, value)}, {"max(T)", most(n, value)}, {"heat", now}};
    double given = 0;
    for (const auto& wall : thermal_.walls)
    {
        if (!wall.passes()) continue;
        const double received = total(particles, wall.heatName());
        given += received;
        columns["heat(" + wall.name + ")"] = received;
        columns["power(" + wall.name + ")"] = total(particles, wall.rateName());
    }
    for (int c = 0; c < dim; ++c) columns[std::string("convection") + char(std::toupper(coordinateNames[c]))] = convection(particles, c);
    if (!particles.holdsAny()) columns["heatBalanceError"] = scale > 0 ? (now - start_.value_or(now) - given) / scale : 0;
    return columns;
}

template<int dim> std::string HeatBalance<dim>::report(const Particles<dim>& particles) const
{
    const auto columns = this->columns(particles);
    if (columns.empty()) return "";
    auto line = fmt::format("T: {:.6g} .. {:.6g} K, heat {:.15g} J", columns.at("min(T)"), columns.at("max(T)"), columns.at("heat"));
    for (const auto& wall : thermal_.walls)
        if (wall.passes())
            line += fmt::format(", {:.6g} W from {} ({:.6g} J so far)", columns.at("power(" + wall.name + ")"), wall.name,
                                columns.at("heat(" + wall.name + ")"));
    if (const auto error = columns.find("heatBalanceError"); error != columns.end())
        line += fmt::format(", balance off by {:.2g}", error->second);
    return line + "\n";
}

template<int dim> std::vector<Stage<dim>> HeatBalance<dim>::stages(JoinPoint place)
{
    if (place == JoinPoint::complete)
        return {{"heat at the start", "sum m Cp T, which changes are of",
                 [this](Particles<dim>& particles, const Substep&)
                 {
                     if (!start_) start_ = heat(particles, plain);
                 }}};
    if (place != JoinPoint::afterKick || !isBuoyant(thermal_)) return {};
    const auto work = [this](Particles<dim>& particles, const Substep&)
    {
        const auto& store = particles.store();
        const double *T = store.component(Temperature::info.name, 0), *m = store.component(Mass::info.name, 0);
        const auto v = store.pointers(Velocity{});
        const auto g = in<dim>(particles.coefficients().g);
        const auto beta = ofPhase(particles, thermal_.beta);
        power_ = sum(particles.size(),
                     [&](std::size_t i) { return -m[i] * beta(i) * (T[i] - thermal_.T0) * dot(g, valueAt<Vector<dim>>(v, i)); });
    };
    return {{"work of buoyancy", "P = -sum m beta (T - T0) g.v", work}};
}

template<int dim> void HeatBalance<dim>::save(Numbers& numbers) const
{
    if (start_) numbers[heatAtStart] = *start_;
}

template class HeatBalance<2>;
template class HeatBalance<3>;

}
