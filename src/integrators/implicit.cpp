/// Backward Euler, linear in the change of velocity: forces at x_0 + dt v_0, and how pressure and viscosity change from there to x_0 + dt v_1
/// (ImplicitSolve.hpp). No limit by sound, stiffness or viscosity; what a step does not resolve is damped. First order.
#include "Integrator.hpp"

namespace sph
{

namespace
{
template<int dim> void stages(Schedule<dim>& schedule)
{
    schedule.join(Place::beforeDrift)
        .driftWhole()
        .join(Place::beforeEvaluation)
        .evaluate()
        .join(Place::solve)
        .kick()
        .driftByKick()
        .join(Place::afterKick)
        .join(Place::afterDrift)
        .join(Place::atEnd)
        .measure();
}
}

const Integrator& implicitIntegrator()
{
    static const Integrator integrator{
        "implicit",
        "pressure and viscosity at the end of the step, solved for: no limit by sound, stiffness or viscosity",
        {.solves = true, .solvesPressure = true},
        stages<2>,
        stages<3>};
    return integrator;
}

}
