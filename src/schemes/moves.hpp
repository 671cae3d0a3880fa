/// The moves that steps are made of, each a loop over the owned particles.
#pragma once
#include "ParticleSystem.hpp"

namespace sph
{

/// x += dt v
template<int dim> void drift(ParticleSystem<dim>&, double deltaT);
/// v += dt dv/dt; rho += dt drho/dt where it is integrated
template<int dim> void kick(ParticleSystem<dim>&, double deltaT);
/// Keeps the start of the step, v_0 = v, then kicks.
template<int dim> void predict(ParticleSystem<dim>&, double deltaT);
/// v = v_0 + dt dv/dt
template<int dim> void correct(ParticleSystem<dim>&, double deltaT);
/// v *= factor
template<int dim> void damp(ParticleSystem<dim>&, double factor);
/// Particle shifting, dx_i = C |v_i| dt Delta_x shift_i, at most a tenth of a spacing.
template<int dim> void shift(ParticleSystem<dim>&, const Settings&, double deltaT);

}
