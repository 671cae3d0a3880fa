/// v(t) stands for v(t + dt/2): first order in what depends on velocity, one evaluation, no memory.
///
///   x^(n+1/2) = x^n + dt/2 v^n,    q^(n+1) = q^n + dt dq/dt(x^(n+1/2), q^n),    x^(n+1) = x^(n+1/2) + dt/2 v^(n+1)
///
/// q all that has a rate: velocity, density, scalars.
#include "integrators/Integrator.hpp"

namespace sph
{

namespace
{
template<int dim> void symplecticEulerStages(Schedule<dim>& schedule)
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
    static const Integrator integrator{"symplecticEuler",
                                       "first order in what depends on velocity, one evaluation a step, no memory",
                                       {},
                                       symplecticEulerStages<2>,
                                       symplecticEulerStages<3>};
    return integrator;
}

}
