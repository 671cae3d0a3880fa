#include "momentumTerms.hpp"
#include "ArtificialViscosity.hpp"
#include "BodyForce.hpp"
#include "Pressure.hpp"
#include "Viscosity.hpp"

namespace sph
{

template<int dim> Catalogue<dim> momentumTerms()
{
    return catalogue<dim, HuAdamsPressure, SeparateHuAdamsPressure, DensityWeightedPressure, MonaghanPressure, DifferencePressure, CorrectedDifferencePressure,
                     TensileControlledPressure, AddPressure, SinglePhaseViscosity, HarmonicViscosity, SinglePhaseResponse, HarmonicResponse,
                     SinglePhaseRate, HarmonicRate, SinglePhaseClearyViscosity, ClearyViscosity, SinglePhaseClearyResponse, ClearyResponse,
                     SinglePhaseClearyRate, ClearyRate, ArtificialViscosity,
                     Gravity, BodyForce>();
}

template Catalogue<2> momentumTerms<2>();
template Catalogue<3> momentumTerms<3>();

}
