#include "operatorTerms.hpp"
#include "FreeSurface.hpp"
#include "GradientCorrection.hpp"
#include "KernelMoment.hpp"
#include "LinearFit.hpp"
#include "StressDivergence.hpp"
#include "VelocityGradient.hpp"

namespace sph
{

template<int dim> Catalogue<dim> operatorTerms()
{
    return catalogue<dim, StressDivergence, DensityWeightedStressDivergence, SecondMoment, GradientNormalisation, GradientCorrection,
                     SurfaceDetection, OutwardNormal, CorrectedVelocityGradient, FitWeights>();
}

template Catalogue<2> operatorTerms<2>();
template Catalogue<3> operatorTerms<3>();

}
