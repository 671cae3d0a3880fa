/// Terms of gravity and body force by name.
#pragma once
#include "plan/Catalogue.hpp"

namespace sph
{

template<int dim> Catalogue<dim> forceTerms();

}
