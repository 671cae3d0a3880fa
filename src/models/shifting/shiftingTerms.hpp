/// Terms of particle shifting and transport velocity by name.
#pragma once
#include "plan/Catalogue.hpp"

namespace sph
{

template<int dim> Catalogue<dim> shiftingTerms();

}
