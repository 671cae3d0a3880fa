/// The rates of the last step predict the middle of this one: second order, one evaluation.
///
///   x^(n+1/2) = x^n + dt/2 v^n,    q* = q^n + dt/2 dq/dt^(n-1/2)
///   q^(n+1) = q^n + dt dq/dt(x^(n+1/2), q*),    x^(n+1) = x^(n+1/2) + dt/2 v^(n+1)
///
/// q all that has a rate: velocity, density, scalars. The extrapolation halves the viscous limit (Adams-Bashforth
/// against mid-point).
#include "integrators/Integrator.hpp"

namespace sph
{

namespace
{
template<int dim> void leapfrogStages(Schedule<dim>& schedule)
{
    schedule.join(JoinPoint::beforeDrift)
        .drift()
        .join(JoinPoint::beforeEvaluation)
        .predict()
        .evaluate()
        .evaluateOnceAStep()
        .correct()
        .kickOnceAStep()
        .join(JoinPoint::afterKick)
        .driftOn()
        .join(JoinPoint::afterDrift)
        .join(JoinPoint::atEnd)
        .measure();
}
}

const Integrator& leapfrogIntegrator()
{
    static const Integrator integrator{"leapfrog",
                                       "second order, one evaluation a step",
                                       {.predicts = true, .keepsRates = true, .viscousFactor = 0.5},
                                       leapfrogStages<2>,
                                       leapfrogStages<3>};
    return integrator;
}

}
