#include "models/pressure/pressureTerms.hpp"
#include "models/pressure/PressureForce.hpp"
#include "models/pressure/PressureResponse.hpp"
#include "models/pressure/Tait.hpp"

namespace sph
{

template<int dim> Catalogue<dim> pressureTerms()
{
    return catalogue<dim, Tait, TaitOrHeld, TaitOfPhase, TaitOfPhaseOrHeld, HuAdamsPressure, DensityWeightedPressure, MonaghanPressure,
                     MassWeightedPressure, DifferencePressure, CorrectedDifferencePressure, TensileControlledPressure, AddPressure,
                     StiffnessOfPhase, UniformStiffness, StrengthOfPressure, ChangeAsDisplacement, CompressionOfChange, RepulsionOfChange,
                     PressureResponse, PressureRate>();
}

template Catalogue<2> pressureTerms<2>();
template Catalogue<3> pressureTerms<3>();

}
