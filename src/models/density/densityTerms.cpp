#include "densityTerms.hpp"
#include "Continuity.hpp"
#include "DensityDiffusion.hpp"
#include "DensityRelaxation.hpp"
#include "NumberDensity.hpp"
#include "RenormalisedDiffusion.hpp"

namespace sph
{

template<int dim> Catalogue<dim> densityTerms()
{
    return catalogue<dim, NumberDensity, SummedDensity, Continuity, MassContinuity, IntegratedVolume, DensityDiffusion, DensityRelaxation,
                     RenormalisedDensityGradient, RenormalisedDiffusion>();
}

template Catalogue<2> densityTerms<2>();
template Catalogue<3> densityTerms<3>();

}
