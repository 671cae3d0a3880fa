/// Terms of surface tension by name.
#pragma once
#include "plan/Catalogue.hpp"

namespace sph
{

template<int dim> Catalogue<dim> tensionTerms();

}
