#include "integrators/Schedule.hpp"
#include "base/StepTooLong.hpp"
#include "integrators/moves.hpp"
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <ostream>

namespace sph
{

template<int dim> Schedule<dim>& Schedule<dim>::join(JoinPoint place)
{
    for (auto& stage : particles_.stages(place)) then(std::move(stage));
    return *this;
}

template<int dim> Schedule<dim>& Schedule<dim>::evaluate()
{
    // Particles::evaluate runs what joins each evaluation; here it is named.
    std::string equation = "all that follows from the state";
    std::vector<std::string> groups{ofEvaluation};
    for (const auto& stage : particles_.stages(JoinPoint::afterEvaluation))
    {
        equation += fmt::format("; {}: {}", stage.name, stage.equation);
        groups.insert(groups.end(), stage.groups.begin(), stage.groups.end());
    }
    return then({ofEvaluation, equation, [](Particles<dim>& p, const Substep&) { p.evaluate(); }, groups});
}

template<int dim> Schedule<dim>& Schedule<dim>::evaluateOnceAStep()
{
    if (!particles_.plan().hasGroup(onceAStep)) return *this;
    return then({onceAStep, "at the same positions", [](Particles<dim>& p, const Substep&) { p.evaluate(onceAStep); }, {onceAStep}, true});
}

template<int dim> Schedule<dim>& Schedule<dim>::drift()
{
    return then({"drift", "x += dt/2 v",
                 [](Particles<dim>& p, const Substep& s)
                 {
                     sph::drift(p, 0.5 * s.deltaT);
                     p.moved(0.5 * s.deltaT * p.maxSpeed());
                 }});
}

template<int dim> Schedule<dim>& Schedule<dim>::driftOn()
{
    lastDrift_ = 0.5;
    return then({"drift on", "x += dt/2 v", [](Particles<dim>& p, const Substep& s) { sph::drift(p, 0.5 * s.deltaT); }});
}

template<int dim> Schedule<dim>& Schedule<dim>::driftByTheta()
{
    const auto driftBy = [](Particles<dim>& p, double deltaT)
    {
        sph::drift(p, deltaT);
        p.moved(std::fabs(deltaT) * p.maxSpeed());
    };
    return then(Stage<dim>{
        "drift", "x += theta dt v", [driftBy](Particles<dim>& p, const Substep& s) {
            driftBy(p, p.settings().integration.theta * s.deltaT);
        }}.undoneBy([driftBy](Particles<dim>& p, const Substep& s) { driftBy(p, -p.settings().integration.theta * s.deltaT); }));
}

template<int dim> Schedule<dim>& Schedule<dim>::driftOnByTheta()
{
    lastDrift_ = 1 - particles_.settings().integration.theta;
    return then({"drift on", "x += (1 - theta) dt v_1 + (2 theta - 1) dt (v_1 - v_0)",
                 [](Particles<dim>& p, const Substep& s)
                 {
                     const double theta = p.settings().integration.theta, beyond = (2 * theta - 1) * sqr(s.deltaT);
                     sph::drift(p, (1 - theta) * s.deltaT);
                     driftByAcceleration(p, beyond);
                     p.moved(beyond * largestAcceleration(p));
                 }});
}

template<int dim> Schedule<dim>& Schedule<dim>::predict()
{
    return then({"predict", "q_0 = q, q += dt/2 dq/dt", [](Particles<dim>& p, const Substep& s) { sph::predict(p, 0.5 * s.deltaT); }});
}

template<int dim> Schedule<dim>& Schedule<dim>::correct()
{
    return then({"correct", "q = q_0 + dt dq/dt", [](Particles<dim>& p, const Substep& s) { sph::correct(p, s.deltaT); }});
}

template<int dim> Schedule<dim>& Schedule<dim>::kick()
{
    return then({"kick", "q += dt dq/dt", [](Particles<dim>& p, const Substep& s) { sph::kick(p, s.deltaT); }});
}

template<int dim> Schedule<dim>& Schedule<dim>::kickOnceAStep()
{
    if (!particles_.plan().hasGroup(onceAStep)) return *this;
    return then({"kick once a step",
                 "v += (whole dt) dv/dt of what acts once a step",
                 [](Particles<dim>& p, const Substep& s) { kickSlowly(p, s.whole); },
                 {},
                 true});
}

template<int dim> Schedule<dim>& Schedule<dim>::complete()
{
    std::vector<std::string> groups;
    for (const auto& stage : particles_.stages(JoinPoint::complete)) groups.insert(groups.end(), stage.groups.begin(), stage.groups.end());
    return then({"complete", "at the new velocities", [](Particles<dim>& p, const Substep&) { p.run(JoinPoint::complete); }, groups});
}

template<int dim> Schedule<dim>& Schedule<dim>::measure()
{
    return then({"measure", "largest speed and acceleration, energy",
                 [this](Particles<dim>& p, const Substep& s)
                 {
                     measure_(s.deltaT);
                     p.moved(lastDrift_ * s.deltaT * p.maxSpeed());
                 }});
}

template<int dim> void Schedule<dim>::run(const Substep& substep, bool middle)
{
    auto stage = stages_.begin();
    try
    {
        for (; stage != stages_.end(); ++stage)
        {
            if (stage->onceAStep && !middle) continue;
            stage->run(particles_, substep);
            ++counts_[stage->name];
        }
    }
    catch (const StepTooLong&)
    {
        for (auto done = std::make_reverse_iterator(stage + 1); done != stages_.rend(); ++done)
            if (done->undo) done->undo(particles_, substep);
        throw;
    }
}

template<int dim> void Schedule<dim>::print(std::ostream& out) const
{
    const auto& plan = particles_.plan();
    int number = 0, pass = 0, operation = 0;
    for (const auto& stage : stages_)
    {
        out << fmt::format("  {}. {:<20} {}{}\n", ++number, stage.name, stage.equation,
                           stage.onceAStep ? " (in the middle one of several parts)" : "");
        for (const auto& group : stage.groups) plan.printGroup(out, plan.group(group), pass, operation);
    }
    const std::pair<JoinPoint, const char*> within[]{{JoinPoint::loaded, "once, when particles are loaded"},
                                                     {JoinPoint::start, "once, after the first evaluation"},
                                                     {JoinPoint::exchange, "before particles are sorted"},
                                                     {JoinPoint::sorted, "when lists are built"},
                                                     {JoinPoint::moved, "before an evaluation without sorting"},
                                                     {JoinPoint::complete, "before fields are looked at"}};
    for (const auto& [place, when] : within)
        for (const auto& stage : particles_.stages(place)) out << fmt::format("  {}: {}, {}\n", when, stage.name, stage.equation);
    plan.printFields(out, particles_.store());
}

template class Schedule<2>;
template class Schedule<3>;

}
