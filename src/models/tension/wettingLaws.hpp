/// Wall laws of wetting by name.
#pragma once
#include "plan/Catalogue.hpp"

namespace sph
{

template<int dim> Catalogue<dim> wettingLaws();

}
