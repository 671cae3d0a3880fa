/// The terms that a relaxation's plan chooses from: those of the densities, and its own.
#pragma once
#include "plan/Catalogue.hpp"

namespace sph
{

/// `V0` [m^dim] volume of a particle.
template<int dim> Catalogue<dim> relaxationTerms(double V0);

}
