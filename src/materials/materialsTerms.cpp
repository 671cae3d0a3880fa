#include "materialsTerms.hpp"
#include "Krieger.hpp"
#include "Tait.hpp"

namespace sph
{

template<int dim> Catalogue<dim> materialsTerms() { return catalogue<dim, Tait, TaitOrHeld, TaitOfPhase, Krieger, KriegerSlope>(); }

template Catalogue<2> materialsTerms<2>();
template Catalogue<3> materialsTerms<3>();

}
