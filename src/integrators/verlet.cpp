/// Verlet's scheme with re-coupling steps, eq. (19) of Peng, Wu & Yu (2014), for steps of any length (TwoLevels.hpp): one evaluation a step, at its start.
///
///   x^(n+1) = x^n + dt v^n + dt^2/2 a^n
///   q^(n+1) = q^n + dq^(n+1),    dq^(n+1) = (dt_0 + dt) dq/dt^n - dq^n,    each `verletSteps` dt dq/dt^n
///
/// q all that has a rate: velocity, density, scalars. What is kept of the level n-1 is the increment dq^n = q^n - q^(n-1), a state of its own: what models change at the end of a step (walls that hold
/// particles off, damping) so changes both levels alike. A stress, which a law integrates, keeps its older level (models/soil/StressUpdate.hpp).
///
/// Second order but for the re-coupling steps, each of first: they leave dt/(2 verletSteps) of the error of Euler's scheme, and let what oscillates undamped with omega grow by
/// omega^2 dt/(2 verletSteps) a second. Waves need some viscosity, artificial or not; too much of it is unstable from two levels, and limits the step by `stableDecay`.
#include "integrators/Integrator.hpp"
#include "integrators/moves.hpp"
#include "scene/TwoLevels.hpp"

namespace sph
{

namespace
{
template<int dim> class Verlet final : public RunningModel<dim>
{
    TwoLevels levels_;

public:
    Verlet(Particles<dim>& particles, const Numbers& restored) : levels_(particles.coefficients().template of<TwoLevels>())
    {
        levels_.restore(restored);
    }
    std::vector<Stage<dim>> stages(JoinPoint place) override
    {
        if (place != JoinPoint::solve) return {};
        return {{"drift", "x += dt v + dt^2/2 dv/dt",
                 [](Particles<dim>& p, const Substep& s)
                 {
                     drift(p, s.deltaT);
                     driftByAcceleration(p, 0.5 * sqr(s.deltaT));
                     p.moved(s.deltaT * p.maxSpeed() + 0.5 * sqr(s.deltaT) * largestAcceleration(p));
                 }},
                {"kick from two levels", "q += dq, dq = (dt_0 + dt) dq/dt - dq; re-coupled dt dq/dt",
                 [this](Particles<dim>& p, const Substep& s) { kickFromTwoLevels(p, s.deltaT, levels_.next(s.deltaT)); }}};
    }
    void save(Numbers& numbers) const override { levels_.save(numbers); }
};

template<int dim> void verletStages(Schedule<dim>& schedule)
{
    schedule.evaluate()
        .join(JoinPoint::beforeDrift)
        .join(JoinPoint::solve)
        .join(JoinPoint::afterKick)
        .join(JoinPoint::afterDrift)
        .join(JoinPoint::atEnd)
        .measure();
}
}

void readVerlet(Settings& settings)
{
    State increments;
    for (const auto& q : settings.state)
        if (q.rate && !q.advancedByModel)
        {
            auto field = q.value;
            field.name = incrementOf(q.value);
            increments.push_back({.value = field, .advancedByModel = true});
        }
    settings.state.insert(settings.state.end(), increments.begin(), increments.end());
    settings.runningModels.push_back(running<Verlet>());
}

const Integrator& verletIntegrator()
{
    static const Integrator integrator{"verlet",
                                       "from two levels of the past, one evaluation a step, re-coupled each verletSteps",
                                       {.twoLevels = true},
                                       verletStages<2>,
                                       verletStages<3>};
    return integrator;
}

}
