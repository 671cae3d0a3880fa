#include "models/openings/RunningOpenings.hpp"
#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <numeric>

namespace sph
{

namespace
{
double sumOf(const std::vector<double>& q) { return std::accumulate(q.begin(), q.end(), 0.0); }
}

template<int dim>
RunningOpenings<dim>::RunningOpenings(Particles<dim>& particles, const Numbers& restored, const std::vector<Opening>& openings)
    : openings_(openings, particles.geometry(), particles.coefficients(), particles.settings().state, restored,
                particles.settings().facts.template get<ForceReach>().supports,
                !particles.settings().multiphase() && particles.settings().facts.template get<FreeSurface>().exists),
      phases_(particles.coefficients().phases),
      solvesPressure_(particles.settings().integration.solvesPressure),
      isMeasured_(particles.settings().facts.template get<BoundaryPower>().isMeasured)
{
    if (isMeasured_) openings_.countEnergy();
}

template<int dim> std::vector<Stage<dim>> RunningOpenings<dim>::stages(JoinPoint place)
{
    const auto hold = [this](Particles<dim>& p) { p.hold(*this, {openings_.held().begin(), openings_.held().end()}); };
    if (place == JoinPoint::exchange)
        return {{"let in and out", "particles beyond planes come, go, and are held",
                 [this](Particles<dim>& p, const Substep&) { p.setSize(openings_.exchange(p.store(), p.size(), p.predicted())); }}};
    if (place == JoinPoint::sorted)
        return {{"find held", "what lies beyond planes, and free particles near them",
                 [this, hold](Particles<dim>& p, const Substep&)
                 {
                     openings_.locate(p.store(), p.size());
                     hold(p);
                 }}};
    if (place == JoinPoint::moved)
        return {{"follow held", "what has passed a plane is held, or free, from now on",
                 [this, hold](Particles<dim>& p, const Substep&)
                 {
                     openings_.follow(p.store(), p.predicted());
                     hold(p);
                 }}};
    if (place == JoinPoint::afterEvaluation)
        return {{"hold", "dq/dt = 0 of what openings hold", [this](Particles<dim>& p, const Substep&) { openings_.hold(p.store()); }}};
    if (place == JoinPoint::solve && solvesPressure_)
        return {{"soften", "dp/drho = 0 of what outlets hold", [this](Particles<dim>& p, const Substep&) { openings_.soften(p.store()); }}};
    if (place == JoinPoint::afterKick)
        return {{"drive", "U and p of what openings hold",
                 [this](Particles<dim>& p, const Substep& s) { openings_.drive(p.store(), s.deltaT, s.time + s.deltaT); }}};
    return {};
}

template<int dim> void RunningOpenings<dim>::withholdRate(Particles<dim>& particles, const std::string& field, double deltaT)
{
    openings_.withholdRate(particles.store(), field, deltaT);
}

template<int dim> std::string RunningOpenings<dim>::ofPhases(const std::vector<double>& q, const std::string& format) const
{
    if (q.size() == 1) return fmt::format(fmt::runtime(format), q[0]);
    std::string text;
    for (std::size_t k = 0; k < q.size(); ++k)
        text += fmt::format("{}{} of {}", k == 0 ? "" : ", ", fmt::format(fmt::runtime(format), q[k]), phases_[k]);
    return text;
}

template<int dim> std::string RunningOpenings<dim>::introduction() const
{
    std::string lines;
    for (const auto& flow : openings_.flows())
        lines += fmt::format("Opening   : {}, {} of {:.4g} {}, {} particles held beyond its plane{}\n", flow.name,
                             flow.inlet ? "inlet" : "outlet", flow.area, dim == 3 ? "m^2" : "m", flow.held,
                             sumOf(flow.taken) > 0
                                 ? fmt::format(", {} further beyond taken away at the start", ofPhases(flow.taken, "{:.6g} kg"))
                                 : "");
    return lines;
}

template<int dim> std::string RunningOpenings<dim>::report(const Particles<dim>& particles) const
{
    auto names = openings_.account().amounts();
    for (auto& name : names) name[0] = char(std::tolower(name[0]));
    std::string lines;
    for (const auto& flow : openings_.flows())
    {
        std::string with;
        for (std::size_t q = 0; q < names.size(); ++q)
            with += fmt::format("{}{:.10g} m^3 of {}", q == 0 ? " with " : ", ", flow.amounts[q], names[q]);
        if (flow.marked && flow.marked->mass > 0)
            with += flow.inlet ? fmt::format(", {:.6g} kg of it marked", flow.marked->mass)
                               : fmt::format(", {:.6g} kg of it marked, {:.4g} s after it came in, standard deviation {:.4g} s",
                                             flow.marked->mass, flow.marked->mean(), flow.marked->deviation());
        lines +=
            fmt::format("{}: {:.6g} m^3/s{}{} at {:.4g} Pa, passed {}{}{}\n", flow.name, flow.flowRate,
                        phases_.size() > 1 ? " (" + ofPhases(flow.flowRates, "{:.6g}") + ")" : "",
                        flow.asked ? fmt::format(" for {:.6g} asked", *flow.asked) : "", flow.pressure, ofPhases(flow.mass, "{:.10g} kg"),
                        with, sumOf(flow.taken) > 0 ? fmt::format(", took away {} at the start", ofPhases(flow.taken, "{:.10g} kg")) : "");
    }
    std::vector<double> letIn(phases_.size(), 0.0);
    for (const auto& model : particles.runningModels())
        for (std::size_t k = 0; k < letIn.size(); ++k) letIn[k] += model->letIn(k);
    const auto off = openings_.imbalance(particles.store(), letIn);
    lines += "balance: mass off by " + ofPhases(off.mass, "{:.2g}");
    for (std::size_t q = 0; q < names.size(); ++q) lines += fmt::format(", {} by {:.2g}", names[q], off.amounts[q]);
    if (phases_.size() > 1) lines += fmt::format(", volume let in {:.6g} m^3", openings_.account().volume());
    return lines + '\n';
}

template<int dim> Numbers RunningOpenings<dim>::columns(const Particles<dim>&) const
{
    Numbers columns;
    if (!openings_.account().marks()) return columns;
    for (const auto& flow : openings_.flows())
        if (!flow.inlet)
            columns.merge(Numbers{{"marked(" + flow.name + ")", flow.marked->mass},
                                  {"transitTime(" + flow.name + ")", flow.marked->mean()},
                                  {"transitDeviation(" + flow.name + ")", flow.marked->deviation()}});
    return columns;
}

template<int dim> void RunningOpenings<dim>::save(Numbers& numbers) const { numbers.merge(openings_.state()); }

template class RunningOpenings<2>;
template class RunningOpenings<3>;

}
