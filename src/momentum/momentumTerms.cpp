#include "momentumTerms.hpp"
#include "BodyForce.hpp"
#include "Pressure.hpp"
#include "Viscosity.hpp"

namespace sph
{

template<int dim> Catalogue<dim> momentumTerms()
{
    return catalogue<dim, HuAdamsPressure, SeparateHuAdamsPressure, DensityWeightedPressure, MonaghanPressure, AddPressure,
                     SinglePhaseViscosity, HarmonicViscosity, SinglePhaseClearyViscosity, ClearyViscosity, Gravity, BodyForce>();
}

template Catalogue<2> momentumTerms<2>();
template Catalogue<3> momentumTerms<3>();

}
