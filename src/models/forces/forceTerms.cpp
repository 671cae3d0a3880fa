#include "models/forces/forceTerms.hpp"
#include "models/forces/BodyForce.hpp"

namespace sph
{

template<int dim> Catalogue<dim> forceTerms() { return catalogue<dim, Gravity, BodyForce>(); }

template Catalogue<2> forceTerms<2>();
template Catalogue<3> forceTerms<3>();

}
