/// Rates at t predict v(t + dt/2), and those at the middle make the step: second order, two evaluations.
#include "integrators/Integrator.hpp"

namespace sph
{

namespace
{
template<int dim> void stages(Schedule<dim>& schedule)
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
    static const Integrator integrator{
        "predictorCorrector", "second order, two evaluations a step", {.predicts = true}, stages<2>, stages<3>};
    return integrator;
}

}
