/// Fields and numbers of soil.
#pragma once
#include "fields/fieldTags.hpp"
#include "scene/State.hpp"
#include "soilLaws/SoilState.hpp"
#include <cmath>

namespace sph
{

/// sigma_0 is the stress of the step before, where steps start from two levels (TwoLevels.hpp); S is what acts on neighbours, in the plane of the flow; c the speed of sound of the law's
/// present stiffness, sqrt(M/rho). T is the shear stress of joints with walls (WallFriction.hpp). On request: gamma = integral of sqrt(2
/// e:e) dt, e = dev D, of all strain to and fro; gamma_p the same of the plastic part of D, of laws that have one; and w = integral of
/// sigma:D dt, what the stress has done to a volume.
// clang-format off
struct SoilStress   { static constexpr FieldInfo info{"sigma", "Pa", Image::mirrored};                              template<int dim, class Real = double> struct At { StressTensor<dim> sigma; }; };
struct OlderStress  { static constexpr FieldInfo info{"sigma_0", "Pa", Image::mirrored};                            template<int dim, class Real = double> struct At { StressTensor<dim> sigma_0; }; };
struct ActingStress { static constexpr FieldInfo info{"actingStress", "Pa", Image::ruled, nullptr, "actingStress"}; template<int dim, class Real = double> struct At { SymmTensor<dim, Real> S; }; };
struct WallShear    { static constexpr FieldInfo info{"wallShear", "Pa", Image::mirrored};                          template<int dim, class Real = double> struct At { SymmTensor<dim, Real> T; }; };
struct StressNoise  { static constexpr FieldInfo info{"stressNoise", "Pa", Image::mirrored};                        template<int dim, class Real = double> struct At { StressTensor<dim> noise; }; };
struct SoilSound    { static constexpr FieldInfo info{"soundSpeed", "m/s"};                                         template<int dim, class Real = double> struct At { Real c; }; };
struct StrainRate   { static constexpr FieldInfo info{"strainRate", "1/s"};  template<int dim, class Real = double> struct At { SymmTensor<dim, Real> D; }; };
struct ShearStrain  { static constexpr FieldInfo info{"shearStrain", "1"};   template<int dim, class Real = double> struct At { Real gamma; }; };
struct PlasticShearStrain { static constexpr FieldInfo info{"plasticShearStrain", "1"}; template<int dim, class Real = double> struct At { Real gamma_p; }; };
struct StressWork   { static constexpr FieldInfo info{"stressWork", "J/m^3"}; template<int dim, class Real = double> struct At { Real w; }; };
// clang-format on

/// Numbers that terms of soil are made from.
struct SoilNumbers
{
    double floorPressure = 0;     ///< of stress-free soil [Pa]; 0 where there is none
    double surfacePressure = 0;   ///< p_s, on free surfaces [Pa]: that of the floor where nothing else is said
    double alpha = 0;             ///< of the artificial viscosity [1]
    bool actsOnRecession = false; ///< and not on approach alone
    double smoothing = 0;         ///< delta of the stress's noise [1]; 0: it is left
    bool smoothsAtRest = false;   ///< and not by strain alone
    double hourglass = 0;         ///< stiffness against motion that no strain answers [1]
    double compactionSpeed = 0;   ///< c_c [m/s]
    double compactFrom = 0;       ///< rho_c [kg/m^3]

    /// The pressure of soil that is denser than its law, which knows no void ratio, has it [Pa]: c_c^2 max(0, rho - rho_c).
    double compactionPressure(double rho) const { return sqr(compactionSpeed) * std::fmax(0.0, rho - compactFrom); }
};

/// The group of the plan that runs at the velocities of a step's end.
inline constexpr const char* ofStrain = "velocity gradient";
/// The group behind it: laws that advance the state of the balanced gradient and of the hourglass stiffness.
inline constexpr const char* ofBalance = "balance of the gradient";

/// Conversions in three dimensions, as base/StressTensor.hpp has them in two.
constexpr SymmTensor<3> inPlane(SymmTensor<3> a) { return a; }
constexpr SymmTensor<3> in3D(SymmTensor<3> a) { return a; }
constexpr Tensor<3> in3D(Tensor<2> a) { return {a.xx, a.xy, 0, a.yx, a.yy, 0, 0, 0, 0}; }
constexpr Tensor<3> in3D(Tensor<3> a) { return a; }
/// Stress of the flow's dimension from a stress in three; in 2-D it must be one of plane strain.
template<int dim> constexpr StressTensor<dim> stressIn(SymmTensor<3> a)
{
    if constexpr (dim == 3) return a;
    else return {a.xx, a.xy, a.yy, a.zz};
}

/// State variables of a law (soilLaws/SoilState.hpp) as fields of particles, in the order of its parts: numbers, and tensors that in two dimensions are those of
/// plane strain.
template<int dim, class Part> using VariableIn = std::conditional_t<std::is_same_v<Part, double>, double, StressTensor<dim>>;

/// Calls f(name, part) with each state variable.
template<class Variables> void forEachVariable(Variables& variables, const auto& f)
{
    [[maybe_unused]] std::size_t k = 0;
    Variables::parts(variables, [&](auto&... part) { (f(Variables::names[k++], part), ...); });
}

template<class Part> StateField fieldOf(const StateVariable& variable, const Part&)
{
    return {{variable.name, variable.unit, std::is_same_v<Part, double> ? Image::copied : Image::mirrored},
            variable.name,
            {valueType<VariableIn<2, Part>>, valueType<VariableIn<3, Part>>}};
}

/// The variables of particle i, from the arrays of all components in order; and back.
template<int dim, class Variables> Variables variablesAt(const auto& arrays, std::size_t i)
{
    Variables variables;
    [[maybe_unused]] std::size_t first = 0;
    forEachVariable(variables,
                    [&]<class Part>(const StateVariable&, Part& part)
                    {
                        VariableIn<dim, Part> q;
                        fetch(q, [&](int c) { return arrays[first + std::size_t(c)][i]; });
                        first += std::size_t(components<VariableIn<dim, Part>>);
                        if constexpr (std::is_same_v<Part, double>) part = q;
                        else part = in3D(q);
                    });
    return variables;
}
template<int dim, class Variables> void storeVariables(const Variables& variables, const auto& arrays, std::size_t i)
{
    [[maybe_unused]] std::size_t first = 0;
    forEachVariable(variables,
                    [&]<class Part>(const StateVariable&, const Part& part)
                    {
                        const auto set = [&](int c, double q) { arrays[first + std::size_t(c)][i] = q; };
                        if constexpr (std::is_same_v<Part, double>) store(part, set);
                        else store(stressIn<dim>(part), set);
                        first += std::size_t(components<VariableIn<dim, Part>>);
                    });
}

}
