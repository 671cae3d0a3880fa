#include "models/viscosity/viscosityTerms.hpp"
#include "models/viscosity/ArtificialViscosity.hpp"
#include "models/viscosity/TransposedViscosity.hpp"

namespace sph
{

template<int dim> Catalogue<dim> viscosityTerms()
{
    return catalogue<dim, SinglePhaseViscosity, HarmonicViscosity, SinglePhaseResponse, HarmonicResponse, SinglePhaseRate, HarmonicRate,
                     SinglePhaseClearyMonaghanViscosity, ClearyMonaghanViscosity, SinglePhaseClearyMonaghanResponse, ClearyMonaghanResponse,
                     SinglePhaseClearyMonaghanRate, ClearyMonaghanRate, SinglePhaseClearyViscosity, ClearyViscosity,
                     SinglePhaseClearyResponse, ClearyResponse, SinglePhaseClearyRate, ClearyRate, ViscousGradientOfPhases,
                     TransposedViscosity, SinglePhaseViscousGradient, SinglePhaseTransposedViscosity, ViscosityOfPhase,
                     ArtificialViscosity>();
}

template Catalogue<2> viscosityTerms<2>();
template Catalogue<3> viscosityTerms<3>();

}
