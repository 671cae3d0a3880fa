/// A step as a list of stages: built at start-up, printed by -dry-run, run in order.
#pragma once
#include "scene/Particles.hpp"
#include <iosfwd>

namespace sph
{

template<int dim> class Schedule
{
public:
    /// `measure`: what looks at the state at the end of a step. The particles must outlive the schedule.
    Schedule(Particles<dim>& particles, std::function<void(double deltaT)> measure) : particles_(particles), measure_(std::move(measure)) {}

    Schedule& then(Stage<dim> stage)
    {
        stages_.push_back(std::move(stage));
        return *this;
    }
    /// The stages of models that join a place.
    Schedule& join(JoinPoint);
    /// An evaluation, and what joins it; behind it, in the middle of a step of several parts, what acts once a step.
    Schedule& evaluate();
    Schedule& evaluateOnceAStep();
    /// dt/2; the second one ends the step, and `measure` says how far it may have gone.
    Schedule& drift();
    Schedule& driftOn();
    /// A share theta of a step, with the velocity at its start, which can be taken back; and on to x_0 + dt ((1 - theta) v_0 + theta v_1).
    Schedule& driftByTheta();
    Schedule& driftOnByTheta();
    Schedule& predict();
    Schedule& correct();
    Schedule& kick();
    Schedule& kickOnceAStep();
    /// Computes the fields that models show or limit steps by, beyond an evaluation.
    Schedule& complete();
    /// The largest speed, the account of energy; how far particles may have moved in the last drift.
    Schedule& measure();

    /// Runs the stages. Where one throws StepTooLong the state is as it was before, to round-off, and the exception goes on; what was held off walls stays so.
    void run(const Substep&, bool middle);
    /// Stages with the passes and operations of the groups that they evaluate, numbered through.
    void print(std::ostream&) const;
    /// Number of runs of each stage, by name.
    const std::map<std::string, long>& counts() const { return counts_; }

private:
    Particles<dim>& particles_;
    std::function<void(double)> measure_;
    std::vector<Stage<dim>> stages_;
    std::map<std::string, long> counts_;
    double lastDrift_ = 0; ///< share of the step for which particles drift with the velocities at its end, whose largest is known behind it
};

}
