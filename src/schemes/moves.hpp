/// The moves that steps are made of, each a loop over the owned particles.
#pragma once
#include "ParticleSystem.hpp"

namespace sph
{

/// x += dt v, or dt (v + w) where there is a transport velocity
template<int dim> void drift(ParticleSystem<dim>&, double deltaT);
/// v += dt dv/dt; rho += dt drho/dt where it is integrated
template<int dim> void kick(ParticleSystem<dim>&, double deltaT);
/// v += dt dv/dt by what acts once in a step of several parts
template<int dim> void kickSlowly(ParticleSystem<dim>&, double deltaT);
/// Keeps the start of the step, v_0 = v, then kicks.
template<int dim> void predict(ParticleSystem<dim>&, double deltaT);
/// v = v_0 + dt dv/dt
template<int dim> void correct(ParticleSystem<dim>&, double deltaT);
/// v *= factor
template<int dim> void damp(ParticleSystem<dim>&, double factor);
/// The transport velocity of a step, w = dt/2 a by the last evaluation (TransportVelocity.hpp): at most a tenth of a spacing in the step.
template<int dim> void transport(ParticleSystem<dim>&, const Settings&, double deltaT);
/// Particle shifting, dx_i = C |v| dt Delta_x shift_i, at most a tenth of a spacing; |v| of the particle, or the largest of all.
template<int dim> void shift(ParticleSystem<dim>&, const Settings&, double maxSpeed, double deltaT);

}
