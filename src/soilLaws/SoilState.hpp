/// The state of a material point of soil: the stress, and the state variables of laws that have some.
///
/// A law without state variables says nothing of them, and its state is the stress alone, of the same size and by the same operations. A
/// law with some names their type, `Law::Variables`: a value whose parts are numbers and symmetric tensors (base/values.hpp), with a name
/// and a unit for each, by which they are fields of particles and columns of tables, and with the operations of a vector, so that they are
/// integrated with the stress by the same substeps. Tensors turn with the material as the stress does.
#pragma once
#include "base/StressTensor.hpp"
#include "base/values.hpp"
#include <array>
#include <cmath>
#include <type_traits>

namespace sph
{

/// A state variable in fields, tables and dictionaries.
struct StateVariable
{
    const char *name, *unit;
};

struct NoVariables
{
    static constexpr std::array<StateVariable, 0> names{};
    static constexpr auto parts(auto&, const auto& f) { return f(); }
    constexpr NoVariables& operator+=(NoVariables) { return *this; }
    friend constexpr NoVariables operator*(double, NoVariables) { return {}; }
};
constexpr NoVariables rotated(NoVariables, Tensor<3>) { return {}; }
constexpr NoVariables turning(NoVariables, Tensor<3>) { return {}; }

/// e, the volume of the pores over that of the grains [1]. The grains keep theirs: de/dt = (1 + e) tr(D).
struct VoidRatio
{
    double e = 0;
    static constexpr std::array<StateVariable, 1> names{{{"voidRatio", "1"}}};
    static constexpr auto parts(auto& q, const auto& f) { return f(q.e); }
    constexpr VoidRatio& operator+=(VoidRatio b)
    {
        e += b.e;
        return *this;
    }
    friend constexpr VoidRatio operator*(double s, VoidRatio a) { return {s * a.e}; }
};
constexpr VoidRatio rotated(VoidRatio a, Tensor<3>) { return a; }
/// After a strain of any size, the grains' volume kept.
inline VoidRatio strainedVoidRatio(VoidRatio q, SymmTensor<3> strain) { return {(1 + q.e) * std::exp(trace(strain)) - 1}; }
constexpr VoidRatio turning(VoidRatio, Tensor<3>) { return {}; }

template<class V> struct SoilState
{
    using Variables = V;
    SymmTensor<3> stress; ///< effective, tension positive [Pa]
    [[no_unique_address]] V variables;

    constexpr SoilState() = default;
    constexpr SoilState(SymmTensor<3> s, const V& v) : stress(s), variables(v) {}
    // Without state variables the two are one.
    constexpr SoilState(SymmTensor<3> s) requires std::is_empty_v<V> : stress(s) {}
    constexpr operator SymmTensor<3>() const requires std::is_empty_v<V> { return stress; }
    constexpr SoilState& operator+=(const SoilState& b)
    {
        stress += b.stress;
        variables += b.variables;
        return *this;
    }
    friend constexpr SoilState operator*(double s, const SoilState& a) { return {s * a.stress, s * a.variables}; }
};
/// Q . Q^T of all that has a direction.
template<class V> constexpr SoilState<V> rotated(const SoilState<V>& s, Tensor<3> Q)
{
    return {rotated(s.stress, Q), rotated(s.variables, Q)};
}
/// Rates by the spin W alone.
template<class V> constexpr SoilState<V> turning(const SoilState<V>& s, Tensor<3> W)
{
    return {turning(s.stress, W), turning(s.variables, W)};
}

/// A law that has state variables.
template<class L>
concept LawWithVariables = requires
{
    typename L::Variables;
};

namespace detail
{
template<class L> struct VariablesOf
{
    using type = NoVariables;
};
template<LawWithVariables L> struct VariablesOf<L>
{
    using type = typename L::Variables;
};
}
template<class L> using StateOf = SoilState<typename detail::VariablesOf<L>::type>;

}
