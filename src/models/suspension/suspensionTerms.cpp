#include "models/suspension/suspensionTerms.hpp"
#include "models/suspension/OfDensity.hpp"
#include "models/suspension/ShearRate.hpp"
#include "models/suspension/ViscosityFlux.hpp"

namespace sph
{

template<int dim> Catalogue<dim> suspensionTerms()
{
    return catalogue<dim, Krieger, KriegerSlope, KriegerOfDensity, KriegerSlopeOfDensity, ViscousShearStress, ResolvedShear,
                     SubParticleShear, VelocityGradientShear, CorrectedGradientShear, PhillipsFlux, PhillipsFluxOfDensity,
                     DiffusivityOfViscosity, ViscosityFluxResponse, ViscosityFluxRate>();
}

template Catalogue<2> suspensionTerms<2>();
template Catalogue<3> suspensionTerms<3>();

}
