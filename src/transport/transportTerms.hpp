/// The terms of this module by name.
#pragma once
#include "Catalogue.hpp"

namespace sph
{

template<int dim> Catalogue<dim> transportTerms();

}
