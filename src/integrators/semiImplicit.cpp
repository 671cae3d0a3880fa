/// Semi-implicit step: as symplecticEuler, but viscosity acts with v(t + dt), solved for (ImplicitSolve.hpp): no viscous limit of the step.
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
        .join(JoinPoint::solve)
        .kick()
        .join(JoinPoint::afterKick)
        .driftOn()
        .join(JoinPoint::afterDrift)
        .join(JoinPoint::atEnd)
        .measure();
}
}

const Integrator& semiImplicitIntegrator()
{
    static const Integrator integrator{
        "semiImplicit", "viscosity at the end of the step, solved for: no viscous limit", {.solves = true}, stages<2>, stages<3>};
    return integrator;
}

}
