/// The terms of this room by name.
#pragma once
#include "Catalogue.hpp"

namespace sph
{

template<int dim> Catalogue<dim> soilTerms();

}
