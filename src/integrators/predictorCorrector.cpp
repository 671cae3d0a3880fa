/// Rates at t predict the middle of the step, and those at the middle make it: second order, two evaluations.
///
///   x^(n+1/2) = x^n + dt/2 v^n,    q* = q^n + dt/2 dq/dt(x^n, q^n)
///   q^(n+1) = q^n + dt dq/dt(x^(n+1/2), q*),    x^(n+1) = x^(n+1/2) + dt/2 v^(n+1)
///
/// q all that has a rate: velocity, density, scalars.
#include "integrators/Integrator.hpp"

namespace sph
{

namespace
{
template<int dim> void predictorCorrectorStages(Schedule<dim>& schedule)
{
    schedule.evaluate()
        .join(JoinPoint::beforeDrift)
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

const Integrator& predictorCorrectorIntegrator()
{
    static const Integrator integrator{"predictorCorrector",
                                       "second order, two evaluations a step",
                                       {.predicts = true},
                                       predictorCorrectorStages<2>,
                                       predictorCorrectorStages<3>};
    return integrator;
}

}
