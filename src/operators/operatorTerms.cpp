#include "operators/operatorTerms.hpp"
#include "operators/BalancedGradient.hpp"
#include "operators/FreeSurface.hpp"
#include "operators/GradientCorrection.hpp"
#include "operators/KernelMoment.hpp"
#include "operators/LinearFit.hpp"
#include "operators/StressDivergence.hpp"
#include "operators/VelocityGradient.hpp"

namespace sph
{

template<int dim> Catalogue<dim> operatorTerms()
{
    return catalogue<dim, StressDivergence, DensityWeightedStressDivergence, SecondMoment, GradientNormalisation, GradientCorrection,
                     SurfaceDetection, OutwardNormal, CorrectedVelocityGradient, FitWeights, BalancedGradientMap, ImbalanceOfGradient,
                     AdvanceOffset, BalancedVelocityGradient, BalancedDivergenceOfChange>();
}

template Catalogue<2> operatorTerms<2>();
template Catalogue<3> operatorTerms<3>();

}
