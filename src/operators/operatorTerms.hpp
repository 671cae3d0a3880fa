/// Terms of the operators that models share, by name.
#pragma once
#include "plan/Catalogue.hpp"

namespace sph
{

template<int dim> Catalogue<dim> operatorTerms();

}
