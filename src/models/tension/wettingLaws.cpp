#include "wettingLaws.hpp"
#include "NearestWall.hpp"
#include "WallAdhesion.hpp"
#include "WallPotential.hpp"
#include "WallTension.hpp"

namespace sph
{

template<int dim> Catalogue<dim> wettingLaws() { return catalogue<dim, WallTension, WallPotential, WallAdhesion, WallNextTo>(); }

template Catalogue<2> wettingLaws<2>();
template Catalogue<3> wettingLaws<3>();

}
