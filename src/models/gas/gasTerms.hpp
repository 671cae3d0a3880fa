/// Terms of gas that is there in part, by name.
#pragma once
#include "plan/Catalogue.hpp"

namespace sph
{

template<int dim> Catalogue<dim> gasTerms();

}
