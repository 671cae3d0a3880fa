/// v(t) stands for v(t + dt/2): first order in what depends on velocity, one evaluation, no memory.
#include "integrators/Integrator.hpp"

namespace sph
{

namespace
{
template<int dim> void stages(Schedule<dim>& schedule)
{
    schedule.join(JoinPoint::beforeDrift)
        .drift()
        .join(JoinPoint::beforeEvaluation)
        .evaluate()
        .evaluateOnceAStep()
        .kick()
        .kickOnceAStep()
        .join(JoinPoint::afterKick)
        .driftOn()
        .join(JoinPoint::afterDrift)
        .join(JoinPoint::atEnd)
        .measure();
}
}

const Integrator& symplecticEulerIntegrator()
{
    static const Integrator integrator{
        "symplecticEuler", "first order in what depends on velocity, one evaluation a step, no memory", {}, stages<2>, stages<3>};
    return integrator;
}

}
