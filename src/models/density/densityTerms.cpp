#include "models/density/densityTerms.hpp"
#include "models/density/Continuity.hpp"
#include "models/density/DensityDiffusion.hpp"
#include "models/density/DensityRelaxation.hpp"
#include "models/density/NumberDensity.hpp"
#include "models/density/RenormalisedDiffusion.hpp"

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
