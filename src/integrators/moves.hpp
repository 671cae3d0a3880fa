/// The moves that steps are made of, each a walk over what evolves (State.hpp).
#pragma once
#include "Particles.hpp"

namespace sph
{

/// x += dt v by all that carries particles
template<int dim> void drift(Particles<dim>&, double deltaT);
/// x += dt (v_1 - v_0) for v_1 - v_0 = dt dv/dt
template<int dim> void driftByKick(Particles<dim>&, double deltaT);
/// q += dt dq/dt
template<int dim> void kick(Particles<dim>&, double deltaT);
/// q += dt dq/dt of what particles carry, but not of their velocities, nor of their densities: who rests is not compressed
template<int dim> void kickCarried(Particles<dim>&, double deltaT);
/// v += dt dv/dt by what acts once in a step of several parts
template<int dim> void kickSlowly(Particles<dim>&, double deltaT);
/// Keeps the start of the step, q_0 = q, then kicks.
template<int dim> void predict(Particles<dim>&, double deltaT);
/// q = q_0 + dt dq/dt
template<int dim> void correct(Particles<dim>&, double deltaT);

}
