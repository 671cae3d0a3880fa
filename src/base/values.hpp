/// Layout of a value: the one place that knows how many numbers a type has, and where they are on disk.
///
/// A type declares its parts in order, `parts(q, f)` calls f(q.x, q.y ...); parts are numbers or have parts themselves, so that what one loop
/// sums may be a struct of tensors. A type that fields have also declares its class on disk and the names of its components there.
#pragma once
#include "base/Single.hpp"
#include "base/StressTensor.hpp"

namespace sph
{

/// A whole number that is computed with as a Real, and on disk is a label.
template<class Real> struct LabelOf
{
    Real number = 0;
    constexpr LabelOf() = default;
    constexpr LabelOf(Real n) : number(n) {}
    constexpr operator Real() const { return number; }
    constexpr explicit operator int() const requires(!std::is_same_v<Real, double>) { return int(number); }
    static constexpr auto parts(auto& q, const auto& f) { return f(q.number); }
    static constexpr auto fieldClass = FieldClass::label;
    static constexpr auto names = std::to_array<std::string_view>({""});
};
using Label = LabelOf<double>;

namespace detail
{
template<class T> struct Components
{
    static constexpr T zero{};
    static constexpr int count = T::parts(zero, []<class... Part>(const Part&...) { return (Components<Part>::count + ... + 0); });
};
template<> struct Components<double>
{
    static constexpr int count = 1;
};
template<> struct Components<Single> : Components<double>
{};

template<class T> struct DoubleOf
{
    using type = T;
};
template<> struct DoubleOf<Single>
{
    using type = double;
};
template<template<int, class> class T, int dim> struct DoubleOf<T<dim, Single>>
{
    using type = T<dim, double>;
};
}
/// The same value in double precision.
template<class T> using InDouble = typename detail::DoubleOf<T>::type;

/// Number of components of a value.
template<class T> constexpr int components = detail::Components<T>::count;

/// Sets number c of a value to component(c), one after another; `store` calls set(c, number).
constexpr void fetch(double& q, const auto& component) { q = component(0); }
constexpr void fetch(Single& q, const auto& component) { q = component(0); }
template<class T> constexpr void fetch(T& q, const auto& component)
{
    [[maybe_unused]] int first = 0;
    T::parts(q, [&]<class... Part>(Part&... part)
             { ((fetch(part, [&](int c) { return component(first + c); }), first += components<Part>), ...); });
}
/// The value whose components the arrays have at i.
template<class Value> constexpr Value valueAt(const auto& arrays, std::size_t i)
{
    Value q;
    fetch(q, [&](int c) { return arrays[std::size_t(c)][i]; });
    return q;
}
constexpr void store(double q, const auto& set) { set(0, q); }
constexpr void store(Single q, const auto& set) { set(0, q); }
template<class T> constexpr void store(const T& q, const auto& set)
{
    [[maybe_unused]] int first = 0;
    T::parts(q, [&]<class... Part>(const Part&... part)
             { ((store(part, [&](int c, auto number) { set(first + c, number); }), first += components<Part>), ...); });
}

/// A value's type as known at run time: its class on disk, and the place there of each component. A component without a place in a value is 0 on disk.
struct ValueType
{
    FieldClass fieldClass = FieldClass::scalar;
    int components = 1;
    std::array<int, 9> place{};
    friend bool operator==(const ValueType&, const ValueType&) = default;
};
template<class T>
constexpr ValueType valueType = []
{
    static_assert(components<T> == int(T::names.size()));
    ValueType type{T::fieldClass, components<T>, {}};
    const auto names = componentNames(T::fieldClass);
    for (std::size_t c = 0; c < T::names.size(); ++c)
        while (names[std::size_t(type.place[c])] != T::names[c]) ++type.place[c];
    return type;
}();
template<> inline constexpr ValueType valueType<double>{};

/// Calls f with a value of the type that `type` describes, of those whose components depend on the direction.
template<int dim> void withDirectedValue(const ValueType& type, const auto& f)
{
    const auto consider = [&]<class T>(T q)
    {
        if (type == valueType<T>) f(q);
    };
    consider(Vector<dim>{});
    consider(SymmTensor<dim>{});
    consider(Tensor<dim>{});
    if constexpr (dim == 2) consider(PlaneStrainStress{});
}

}
