/// The moves that steps are made of, each a walk over what evolves (State.hpp).
#pragma once
#include "scene/Particles.hpp"

namespace sph
{

/// x += dt v by all that carries particles, and of walls that move
template<int dim> void drift(Particles<dim>&, double deltaT);
/// x += square dv/dt, square [s^2]
template<int dim> void driftByAcceleration(Particles<dim>&, double square);
/// q += dt dq/dt
template<int dim> void kick(Particles<dim>&, double deltaT);
/// q += dt dq/dt of what particles carry, but not of their velocities, nor of their densities: who rests is not compressed
template<int dim> void kickCarried(Particles<dim>&, double deltaT);
/// q += dq, dq = (dt_0 + dt) dq/dt - dq, without the last where dt_0 = 0 (TwoLevels.hpp)
template<int dim> void kickFromTwoLevels(Particles<dim>&, double deltaT, double lastDeltaT);
/// v += dt dv/dt by what acts once in a step of several parts
template<int dim> void kickSlowly(Particles<dim>&, double deltaT);
/// Keeps the start of the step, q_0 = q, then kicks.
template<int dim> void predict(Particles<dim>&, double deltaT);
/// q = q_0 + dt dq/dt
template<int dim> void correct(Particles<dim>&, double deltaT);
/// [m/s^2]
template<int dim> double largestAcceleration(const Particles<dim>&);

}
