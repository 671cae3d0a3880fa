#include "interfacesTerms.hpp"
#include "CurvatureForce.hpp"
#include "InterfaceStress.hpp"
#include "SolidPhase.hpp"

namespace sph
{

template<int dim> Catalogue<dim> interfacesTerms()
{
    return catalogue<dim, InterfaceStress, AddWallStress, SolidPhaseStress, StressOfSolid, ColourSmoothing, SmoothedColourGradient,
                     AdheringColourGradient, InterfaceCurvature, CurvatureSmoothing, CurvatureForce>();
}

template Catalogue<2> interfacesTerms<2>();
template Catalogue<3> interfacesTerms<3>();

}
