/// Quasi-steady step, for flows that change only as what they carry does: particles stay in place, velocities are those of creeping flow, solved for, and time
/// is that of the powder's migration, or of what diffuses.
///
///   0 = a(v) of viscosity, pressure and forces,    q^(n+1) = q^n + dt dq/dt,    x^(n+1) = x^n
///
/// q what particles carry: powder, scalars.
#include "integrators/Integrator.hpp"
#include "integrators/moves.hpp"

namespace sph
{

namespace
{
template<int dim> void quasiSteadyStages(Schedule<dim>& schedule)
{
    schedule.join(JoinPoint::afterKick)
        .then({"kick what is carried", "q += dt dq/dt", [](Particles<dim>& p, const Substep& s) { kickCarried(p, s.deltaT); }})
        .evaluate()
        .join(JoinPoint::solve)
        .complete()
        .join(JoinPoint::atEnd)
        .measure();
}
}

const Integrator& quasiSteadyIntegrator()
{
    static const Integrator integrator{"quasiSteady",
                                       "creeping flow of particles at rest that changes as what it carries does",
                                       {.solves = true, .moves = false},
                                       quasiSteadyStages<2>,
                                       quasiSteadyStages<3>};
    return integrator;
}

}
