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

namespace entry
{
/// The void ratio of the soil at the start, beside its stress, with laws that have it.
inline const Scalar voidRatio{"voidRatio", units::none, byScene("needed with a law that has it, where no field gives it"), positive,
                              "e, the volume of the pores over that of the grains; of sand e_d to e_i of the law at the pressure"};
}

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
concept ConstitutiveLaw = requires(const L& law, const StateOf<L>& state, SymmTensor<3> D)
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
    /// The state itself, or where rounding and truncation have brought it out of the law's range, what it is put back to.
    {
        law.returned(state)
        } -> std::convertible_to<StateOf<L>>;
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
    requires(const L& law, const StateOf<L>& state, SymmTensor<3> strain, SymmTensor<3> stress, const Dictionary& d)
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
    /// Why a state cannot be, in words with the values that are possible; empty where it can.
    {
        law.objection(state)
        } -> std::same_as<std::string>;
    /// The variables at the start as a function of the stress there, from where the start is said; and their entries there: all; the one
    /// that an objection is about; whether those that are needed are given; and these in words.
    {
        law.readVariables(d)(stress)
        } -> std::same_as<typename L::Variables>;
    {
        L::startEntry()
        } -> std::convertible_to<const Parameter&>;
    {
        L::startGiven(d)
        } -> std::same_as<bool>;
    {
        L::startWords
        } -> std::convertible_to<const char*>;
    {
        L::variableEntries()
        } -> std::same_as<EntryList>;
};

/// A law that knows the volume of the pores: the density follows.
template<class L>
concept LawOfVoidRatio = LawOfState<L> && requires(const L& law, const StateOf<L>& state)
{
    /// Volume of the grains over that of the soil, which the density is proportional to.
    {
        law.solidShare(state.variables)
        } -> std::same_as<double>;
};

/// A law with a yield surface, on which its rate has a kink.
template<class L>
concept LawWithYieldSurface = ConstitutiveLaw<L> && requires(const L& law, const StateOf<L>& state)
{
    /// True where the state is on the yield surface.
    {
        law.yields(state)
        } -> std::same_as<bool>;
    /// Distance of a state beyond it [Pa]; 0 within and on it.
    {
        law.beyond(state)
        } -> std::same_as<double>;
};

/// A law that is linearly elastic within a yield surface. Given the strain rate, a step is then an elastic part that is known in closed
/// form, and flow on the surface; the strain has a plastic part.
template<class L>
concept ElastoPlasticLaw = LawWithYieldSurface<L> &&
    requires(const L& law, const StateOf<L>& state, SymmTensor<3> D, const EmbeddedPair& pair, SubSteps& taken)
{
    /// The elastic law within.
    law.elastic;
    /// The state after a strain at a constant rate, from one that is admitted.
    {
        law.strained(state, D, pair, 1.0, taken)
        } -> std::convertible_to<StateOf<L>>;
};

/// A law with cohesion and friction: itself with both over a factor, by which factors of safety are found (strength reduction).
template<class L>
concept LawOfStrength = ConstitutiveLaw<L> && requires(const L& law)
{
    {
        law.reduced(1.0)
        } -> std::same_as<L>;
};

/// sin(atan(tan(phi)/F))
inline double reducedSinPhi(double sinPhi, double F) { return sinPhi / std::sqrt(sinPhi * sinPhi + F * F * (1 - sinPhi * sinPhi)); }

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

/// True where a substep may end at the state: a law whose stiffness vanishes with the stress says where it has some, or it is where no
/// principal stress is tensile.
template<ConstitutiveLaw L> bool mayEndAt(const L& law, const StateOf<L>& state)
{
    if constexpr (requires { law.bears(state); }) return law.bears(state);
    else return !L::tensionless || isCompressive(state.stress);
}

}
