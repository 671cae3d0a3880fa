#include "continuityTerms.hpp"
#include "Continuity.hpp"
#include "DensityDiffusion.hpp"
#include "NumberDensity.hpp"
#include "RenormalisedDiffusion.hpp"

namespace sph
{

template<int dim> Catalogue<dim> continuityTerms()
{
    return catalogue<dim, NumberDensity, SummedDensity, Continuity, IntegratedVolume, DensityDiffusion, RenormalisedDensityGradient,
                     RenormalisedDiffusion>();
}

template Catalogue<2> continuityTerms<2>();
template Catalogue<3> continuityTerms<3>();

}
