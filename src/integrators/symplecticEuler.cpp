/// v(t) stands for v(t + dt/2): first order in what depends on velocity, one evaluation, no memory.
#include "Integrator.hpp"

namespace sph
{

namespace
{
template<int dim> void stages(Schedule<dim>& schedule)
{
    schedule.join(Place::beforeDrift)
        .drift()
        .join(Place::beforeEvaluation)
        .evaluate()
        .evaluateOnceAStep()
        .kick()
        .kickOnceAStep()
        .join(Place::afterKick)
        .driftOn()
        .join(Place::afterDrift)
        .join(Place::atEnd)
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
