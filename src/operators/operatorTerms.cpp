#include "operatorTerms.hpp"
#include "FreeSurface.hpp"
#include "GradientCorrection.hpp"
#include "KernelMoment.hpp"
#include "ParticleShifting.hpp"
#include "StressDivergence.hpp"
#include "TransportVelocity.hpp"

namespace sph
{

template<int dim> Catalogue<dim> operatorTerms()
{
    return catalogue<dim, StressDivergence, DensityWeightedStressDivergence, SecondMoment, GradientNormalisation, GradientCorrection, ConcentrationGradient,
                     SeparateConcentrationGradient, SurfaceShifting, SurfaceDetection, OutwardNormal, UniformTransport,
                     LocalTransport, TransportStress>();
}

template Catalogue<2> operatorTerms<2>();
template Catalogue<3> operatorTerms<3>();

}
