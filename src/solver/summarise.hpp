/// Sums and extremes over the owned particles, in a fixed order: the same bits on any number of threads.
#pragma once
#include "scene/Particles.hpp"
#include "solver/Simulation.hpp"

namespace sph
{

template<int dim> Summary summarise(const Particles<dim>&);

}
