/// Semi-implicit step: as symplecticEuler, but viscosity acts with v(t + dt), solved for (ImplicitSolve.hpp): no viscous limit of the step.
///
///   x^(n+1/2) = x^n + dt/2 v^n,    v^(n+1) = v^n + dt (a(x^(n+1/2), v^n) + L (v^(n+1) - v^n)),    x^(n+1) = x^(n+1/2) + dt/2 v^(n+1)
///
/// a [m/s^2] all accelerations, L v that by viscosity.
#include "integrators/Integrator.hpp"

namespace sph
{

namespace
{
template<int dim> void semiImplicitStages(Schedule<dim>& schedule)
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
    static const Integrator integrator{"semiImplicit",
                                       "viscosity at the end of the step, solved for: no viscous limit",
                                       {.solves = true},
                                       semiImplicitStages<2>,
                                       semiImplicitStages<3>};
    return integrator;
}

}
