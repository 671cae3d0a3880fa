/// Forces at x_0 + theta dt v_0, and how pressure and viscosity change from there to x_0 + theta dt (v_0 + theta dv), linear in dv (ImplicitSolve.hpp):
///
///   (1 - theta dt L - theta^2 dt^2 K) dv = dt a(x_0 + theta dt v_0, v_0),    v_1 = v_0 + dv,    x_1 = x_0 + dt (v_0 + theta dv)
///
/// No limit by sound or stiffness, and none by viscosity where it is solved for: it acts at the start of the step where something else allows no longer ones (models/viscosity).
///
/// An oscillation of rate omega is damped by (2 theta - 1) omega^2 dt/2 [1/s], and one that a step does not resolve multiplied by 1 - 1/theta a step:
/// theta 1/2 is of second order, theta 1, the default, is Euler's backward step: what it gains and loses is in the room's README. Verified by test/unit/integrators/stepTest.
#include "integrators/Integrator.hpp"

namespace sph
{

namespace
{
template<int dim> void stages(Schedule<dim>& schedule)
{
    schedule.join(JoinPoint::beforeDrift)
        .driftByTheta()
        .join(JoinPoint::beforeEvaluation)
        .evaluate()
        .join(JoinPoint::solve)
        .kick()
        .join(JoinPoint::afterKick)
        .driftOnByTheta()
        .join(JoinPoint::afterDrift)
        .join(JoinPoint::atEnd)
        .measure();
}
}

const Integrator& implicitIntegrator()
{
    static const Integrator integrator{
        "implicit",
        "pressure within the step, and viscosity where it would shorten it, solved for: no limit by sound or stiffness",
        {.solves = true, .solvesPressure = true},
        stages<2>,
        stages<3>};
    return integrator;
}

}
