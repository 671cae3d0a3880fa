#include "viscosityTerms.hpp"
#include "ArtificialViscosity.hpp"
#include "Viscosity.hpp"

namespace sph
{

template<int dim> Catalogue<dim> viscosityTerms()
{
    return catalogue<dim, SinglePhaseViscosity, HarmonicViscosity, SinglePhaseResponse, HarmonicResponse, SinglePhaseRate, HarmonicRate,
                     SinglePhaseClearyViscosity, ClearyViscosity, SinglePhaseClearyResponse, ClearyResponse, SinglePhaseClearyRate, ClearyRate,
                     ViscosityOfPhase, ArtificialViscosity>();
}

template Catalogue<2> viscosityTerms<2>();
template Catalogue<3> viscosityTerms<3>();

}
