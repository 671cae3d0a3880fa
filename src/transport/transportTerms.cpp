#include "transportTerms.hpp"
#include "PhillipsFlux.hpp"
#include "ShearRate.hpp"

namespace sph
{

template<int dim> Catalogue<dim> transportTerms()
{
    return catalogue<dim, ViscousShearStress, ResolvedShear, SubParticleShear, VelocityGradientShear, CorrectedGradientShear, PhillipsFlux>();
}

template Catalogue<2> transportTerms<2>();
template Catalogue<3> transportTerms<3>();

}
