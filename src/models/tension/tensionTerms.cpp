#include "models/tension/tensionTerms.hpp"
#include "models/tension/CurvatureForce.hpp"
#include "models/tension/InterfaceStress.hpp"
#include "models/tension/SolidPhase.hpp"

namespace sph
{

template<int dim> Catalogue<dim> tensionTerms()
{
    return catalogue<dim, InterfaceStress, SolidPhaseStress, StressOfSolid, ColourSmoothing, SmoothedColourGradient, AdheringColourGradient,
                     InterfaceCurvature, CurvatureSmoothing, CurvatureForce, EvenCurvatureForce>();
}

template Catalogue<2> tensionTerms<2>();
template Catalogue<3> tensionTerms<3>();

}
