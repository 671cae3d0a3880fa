#include "models/shifting/shiftingTerms.hpp"
#include "models/shifting/ParticleShifting.hpp"
#include "models/shifting/TransportVelocity.hpp"

namespace sph
{

template<int dim> Catalogue<dim> shiftingTerms()
{
    return catalogue<dim, ConcentrationGradient, InterfaceShifting, SeparateConcentrationGradient, ConcentrationWithinPhase,
                     SurfaceShifting, InteriorShifting, UniformTransport, LocalTransport, TransportStress>();
}

template Catalogue<2> shiftingTerms<2>();
template Catalogue<3> shiftingTerms<3>();

}
