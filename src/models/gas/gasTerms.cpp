#include "models/gas/gasTerms.hpp"
#include "models/gas/AmbientGas.hpp"

namespace sph
{

template<int dim> Catalogue<dim> gasTerms()
{
    return catalogue<dim, NumberDensityOrRest, GradientNormalisationOrRest, TaitOfPhaseOrAmbient, TaitOfPhaseOrHeldOrAmbient,
                     AmbientPressure>();
}

template Catalogue<2> gasTerms<2>();
template Catalogue<3> gasTerms<3>();

}
