/// A test of the laboratory on one element of soil, homogeneous, without SPH.
#pragma once
#include "base/CaseError.hpp"
#include "soilLaws/soilLaws.hpp"
#include <optional>
#include <vector>

namespace sph
{

/// The components of a symmetric tensor in the order of its names.
inline constexpr double SymmTensor<3>::*symmComponents[]{&SymmTensor<3>::xx, &SymmTensor<3>::xy, &SymmTensor<3>::xz,
                                                         &SymmTensor<3>::yy, &SymmTensor<3>::yz, &SymmTensor<3>::zz};

/// A part of the strain that is found so that a measure of the stress goes where it is to go.
struct StressControl
{
    SymmTensor<3> strain;              ///< its direction
    SymmTensor<3> measure;             ///< measure:sigma [Pa] is what is controlled
    std::optional<double> target = {}; ///< at the end of the piece [Pa]; none: it stays
};
/// A component of the stress that is held by that of the strain.
StressControl heldComponent(double SymmTensor<3>::*);

/// A straight piece of the path: L dt of the whole piece, without what its controls find.
struct ElementLeg
{
    Tensor<3> deformation = {};
    double path = 0; ///< what the test is driven by at the end of the piece: strain [-], angle [degrees] or stress [Pa]
    std::vector<StressControl> controls = {};
    bool drains = true; ///< else the total lateral stress stays, and what the effective one gives up is pressure of the water in the pores
    std::string stage = {}; ///< name, where the test has stages
};

struct ElementTest
{
    std::string name, type;
    std::string pathAxis;               ///< what ElementLeg::path is, for the axis of a plot
    SymmTensor<3> stress;               ///< at the start [Pa]
    std::vector<double> variables = {}; ///< those of the law, at the start
    std::vector<ElementLeg> legs = {};
    int points = 100; ///< rows of a leg
    Location where = {};
};

/// Tension and extension are positive.
struct ElementRow
{
    double path = 0;
    SymmTensor<3> strain = {}, stress = {}; ///< the sum of D dt [-]; [Pa], effective
    std::vector<double> variables = {};     ///< those of the law
    double porePressure = 0;                ///< since the last drained piece [Pa]
    StressState state = StressState::regular;
    SubSteps subSteps = {}; ///< since the row before
    std::string stage = {};
};

/// Throws CaseError, with the test and the path so far, where a stress is inadmissible or no strain rate holds what is to be held.
std::vector<ElementRow> runElementTest(const Soil&, const ElementTest&);

/// The strain rate with those components of `D` that are held changed so that their stresses stay, for the spin W; none where there is
/// none. `variables`: those of the law.
std::optional<SymmTensor<3>> heldStrainRate(const SoilLaw&, SymmTensor<3> stress, SymmTensor<3> D, Tensor<3> W,
                                            const std::array<bool, 6>& held, const std::vector<double>& variables = {});

/// The state of a law from the stress and the numbers of its variables, and those numbers.
template<class State> State stateFrom(SymmTensor<3> stress, const std::vector<double>& variables)
{
    State s;
    s.stress = stress;
    fetch(s.variables, [&](int c) { return variables.at(std::size_t(c)); });
    return s;
}
template<class Variables> std::vector<double> numbersOf(const Variables& variables)
{
    std::vector<double> numbers;
    store(variables, [&](int, double q) { numbers.push_back(q); });
    return numbers;
}

/// sqrt(3 J2) [Pa]; |sigma_1 - sigma_3| where two principal stresses are equal.
double deviatorStress(SymmTensor<3>);

}
