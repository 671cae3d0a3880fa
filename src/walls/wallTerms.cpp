#include "wallTerms.hpp"
#include "WallFilter.hpp"

namespace sph
{

template<int dim> Catalogue<dim> wallTerms() { return catalogue<dim, WallFilter>(); }

template Catalogue<2> wallTerms<2>();
template Catalogue<3> wallTerms<3>();

}
