/// A test of the laboratory on one element of soil, homogeneous, without SPH.
#pragma once
#include "base/CaseError.hpp"
#include "soilLaws/soilLaws.hpp"

namespace sph
{

/// The components of a symmetric tensor in the order of its names.
inline constexpr double SymmTensor<3>::*symmComponents[]{&SymmTensor<3>::xx, &SymmTensor<3>::xy, &SymmTensor<3>::xz,
                                                         &SymmTensor<3>::yy, &SymmTensor<3>::yz, &SymmTensor<3>::zz};

/// A straight piece of the path: L dt of the whole piece. For a component whose stress is held, its own part of L is unknown.
struct ElementLeg
{
    Tensor<3> deformation;
    double path = 0; ///< what the test is driven by at the end of the piece: strain [-] or angle [degrees]
};

struct ElementTest
{
    std::string name, type;
    std::string pathAxis; ///< what ElementLeg::path is, for the axis of a plot
    SymmTensor<3> stress; ///< at the start [Pa]
    std::vector<ElementLeg> legs;
    std::array<bool, 6> held{}; ///< whose stress is held, as in symmComponents
    int points = 100;           ///< rows of a leg
    Location where;
};

/// Tension and extension are positive.
struct ElementRow
{
    double path = 0;
    SymmTensor<3> strain, stress; ///< the sum of D dt [-]; [Pa]
    StressState state = StressState::regular;
    SubSteps subSteps; ///< since the row before
};

/// Throws CaseError, with the test and the path so far, where a stress is inadmissible or no strain rate holds what is to be held.
std::vector<ElementRow> runElementTest(const Soil&, const ElementTest&);

/// The strain rate with those components of `D` that are held changed so that their stresses stay, for the spin W; none where there is none.
std::optional<SymmTensor<3>> heldStrainRate(const SoilLaw&, SymmTensor<3> stress, SymmTensor<3> D, Tensor<3> W,
                                            const std::array<bool, 6>& held);

/// sqrt(3 J2) [Pa]; |sigma_1 - sigma_3| where two principal stresses are equal.
double deviatorStress(SymmTensor<3>);

}
