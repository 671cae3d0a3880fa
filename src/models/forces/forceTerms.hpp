/// Terms of gravity and body force by name.
#pragma once
#include "Catalogue.hpp"

namespace sph
{

template<int dim> Catalogue<dim> forceTerms();

}
