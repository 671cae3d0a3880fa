/// Sums and extremes over the owned particles, in a fixed order: the same bits on any number of threads.
#pragma once
#include "ParticleSystem.hpp"

namespace sph
{

template<int dim> Summary summarise(ParticleSystem<dim>&, const Settings&);

}
