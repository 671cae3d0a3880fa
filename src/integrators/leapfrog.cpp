/// The rates of the last step predict v(t + dt/2): second order, one evaluation. The extrapolation halves the viscous limit (Adams-Bashforth
/// against mid-point).
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
                                       stages<2>,
                                       stages<3>};
    return integrator;
}

}
