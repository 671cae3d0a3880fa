#include "models/tension/wettingLaws.hpp"
#include "models/tension/NearestWall.hpp"
#include "models/tension/WallAdhesion.hpp"
#include "models/tension/WallPotential.hpp"
#include "models/tension/WallTension.hpp"

namespace sph
{

template<int dim> Catalogue<dim> wettingLaws() { return catalogue<dim, WallTension, WallPotential, WallAdhesion, WallNextTo>(); }

template Catalogue<2> wettingLaws<2>();
template Catalogue<3> wettingLaws<3>();

}
