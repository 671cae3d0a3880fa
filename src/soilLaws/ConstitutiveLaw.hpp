/// The concept of a constitutive law of soil: a value with a few constants, and pure functions of the state, which is the stress, and for
/// some laws state variables with it (SoilState.hpp).
///
/// Tension is positive in stresses, extension in strains and their rates, D = (grad v + grad v^T)/2, in three dimensions also where the flow
/// has two (`in3D` of base/StressTensor.hpp). A law that is elastic within a yield surface says so by ElastoPlasticLaw. A law of one's own
/// is one header that satisfies this concept and one word in soilLaws.hpp.
#pragma once
#include "base/StressTensor.hpp"
#include "dictionary/EntryList.hpp"
#include "soilLaws/EmbeddedPair.hpp"
#include "soilLaws/SoilState.hpp"
#include <concepts>
#include <string>

namespace sph
{

/// An option of a law: read from the coefficients of the law beside its own entries, and no word of its own.
template<class L>
concept OptionOfLaw = requires(const Dictionary& coeffs, const typename L::Option& law)
{
    {
        L::read(coeffs, law)
        } -> std::same_as<L>;
    {
        L::given(coeffs)
        } -> std::same_as<bool>;
};

template<class L>
concept ConstitutiveLaw = requires(const L& law, const StateOf<L>& state, SymmTensor<3> stress, SymmTensor<3> D)
{
    {
        L::name
        } -> std::convertible_to<const char*>;
    {
        L::meaning
        } -> std::convertible_to<const char*>;
    /// True where the stiffness vanishes with the stress, so that a stress-free particle is a case of its own, and no integral of the law
    /// has a tensile principal stress.
    {
        L::tensionless
        } -> std::convertible_to<bool>;
    /// Jaumann rate of the stress [Pa/s], and of the state variables.
    {
        law.rate(state, D)
        } -> std::convertible_to<StateOf<L>>;
    /// Bound of the moduli d(stress)/d(strain) of all directions [Pa]; the square of the speed of sound times the density.
    {
        law.stiffness(state)
        } -> std::same_as<double>;
    /// False where the law does not hold for the state.
    {
        law.admits(state)
        } -> std::same_as<bool>;
    /// The stress itself, or where rounding and truncation have brought it out of the law's range, what it is put back to.
    {
        law.returned(stress)
        } -> std::same_as<SymmTensor<3>>;
    {
        L::entries()
        } -> std::same_as<EntryList>;
}
&&(OptionOfLaw<L> || requires(const Dictionary& coeffs) {
    {
        L::read(coeffs)
        } -> std::same_as<L>;
});

/// What a law with state variables has beside that.
template<class L>
concept LawOfState = ConstitutiveLaw<L> && LawWithVariables<L> &&
    requires(const L& law, const StateOf<L>& state, SymmTensor<3> strain, const Dictionary& d)
{
    /// The error of the variables at a state, as a relative error of the stress counts.
    {
        law.variableError(state.variables, state)
        } -> std::same_as<double>;
    /// True where the grains do not touch: the soil is free of stress.
    {
        law.apart(state)
        } -> std::same_as<bool>;
    /// The variables of soil that is strained while its law does not hold, or at no stress.
    {
        law.strainedFreely(state.variables, strain)
        } -> std::same_as<typename L::Variables>;
    /// Volume of the grains over that of the soil, which the density is proportional to.
    {
        law.solidShare(state.variables)
        } -> std::same_as<double>;
    /// Why a state cannot be, in words with the values that are possible; empty where it can.
    {
        law.objection(state)
        } -> std::same_as<std::string>;
    /// The variables at the start, from where the start is said, and their entries there.
    {
        law.readVariables(d)
        } -> std::same_as<typename L::Variables>;
    {
        L::variableEntries()
        } -> std::same_as<EntryList>;
};

/// A law that is linearly elastic within a yield surface. Given the strain rate, a step is then an elastic part that is known in closed
/// form, and flow on the surface; the strain has a plastic part.
template<class L>
concept ElastoPlasticLaw = ConstitutiveLaw<L> &&
    requires(const L& law, SymmTensor<3> stress, SymmTensor<3> D, const EmbeddedPair& pair, SubSteps& taken)
{
    /// The elastic law within.
    law.elastic;
    /// True where the stress is on the yield surface.
    {
        law.yields(stress)
        } -> std::same_as<bool>;
    /// The stress after a strain at a constant rate, from one that is admitted.
    {
        law.strained(stress, D, pair, 1.0, taken)
        } -> std::same_as<SymmTensor<3>>;
};

/// The stress of such a strain is small, whatever the stiffness, to laws that pass through a stress of 0.
inline constexpr double smallStrain = 1e-6;

/// |a| = sqrt(a : a)
inline double norm(SymmTensor<3> a) { return std::sqrt(doubleDot(a, a)); }

/// a . a
constexpr SymmTensor<3> square(SymmTensor<3> a)
{
    const double xy = a.xy * a.xy, xz = a.xz * a.xz, yz = a.yz * a.yz;
    return {a.xx * a.xx + xy + xz, a.xy * (a.xx + a.yy) + a.xz * a.yz, a.xz * (a.xx + a.zz) + a.xy * a.yz,
            xy + a.yy * a.yy + yz, a.yz * (a.yy + a.zz) + a.xy * a.xz, xz + yz + a.zz * a.zz};
}

/// True where no principal stress is tensile, but for rounding, 1e-12 of the trace. By Cholesky's pivots, which keep the sign of an eigenvalue
/// near 0 also where two of them are equal; eigenvalues by Smith's formula are then good to 1e-8 alone. False for NaN and for no stress.
constexpr bool isCompressive(SymmTensor<3> s)
{
    constexpr double rounding = 1e-12;
    const double shift = -rounding * trace(s), first = shift - s.xx;
    if (!(first > 0)) return false;
    const double xy = s.xy / first, xz = s.xz / first, second = shift - s.yy - xy * s.xy, yz = s.yz + xz * s.xy;
    if (!(second > 0)) return false;
    return shift - s.zz - xz * s.xz - yz * yz / second > 0;
}

}
