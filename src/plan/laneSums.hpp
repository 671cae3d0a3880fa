/// Sum of f(0) ... f(n - 1) in vector lanes, of any value with up to 15 numbers (two tensors, one of them symmetric).
///
/// Values of single precision are summed in double where they have few numbers, as forces do: what two particles exert on one another then cancels. Sums of more, fits
/// and gradients that no law of conservation binds, are of floats: as doubles they take twice the registers, and most of them were spilled.
///
/// Each number is a scalar of its own, since GCC 12 reduces scalars, and arrays at a loss of a factor 2; those that a value does not have are
/// never added to, and go. A struct of the loop's body whose address is taken, as `store` does, keeps the loop from being vectorised: `numbers`
/// takes it by value. The instructions are those of a loop written out for each type (objdump of all terms).
#pragma once
#include "base/values.hpp"
#include <utility>

namespace sph
{

/// Numbers of a value of single precision, at most, that are summed in double.
inline constexpr int mostInDouble = 6;

namespace detail
{
/// double or float, of which a value's numbers are made.
template<class Value> using NumberOf = std::conditional_t<std::is_same_v<Value, InDouble<Value>>, double, float>;
template<class Value> struct Numbers
{
    NumberOf<Value> number[components<Value>];
};
template<class Value> constexpr Numbers<Value> numbers(const Value value)
{
    Numbers<Value> q;
    store(value, [&](int c, auto a) { q.number[c] = NumberOf<Value>(a); });
    return q;
}
}

template<class Value, class F> InDouble<Value> sum(int n, const F& f)
{
    constexpr int count = components<Value>;
    static_assert(count <= 15, "a term sums up to 15 numbers at once");
    using Number = std::conditional_t<count <= mostInDouble, double, detail::NumberOf<Value>>;
    Number s0 = 0, s1 = 0, s2 = 0, s3 = 0, s4 = 0, s5 = 0, s6 = 0, s7 = 0, s8 = 0, s9 = 0, s10 = 0, s11 = 0, s12 = 0, s13 = 0, s14 = 0;
#pragma omp simd reduction(+ : s0, s1, s2, s3, s4, s5, s6, s7, s8, s9, s10, s11, s12, s13, s14)
    for (int t = 0; t < n; ++t)
    {
        const auto q = detail::numbers<Value>(f(t));
        s0 += q.number[0];
        if constexpr (count > 1) s1 += q.number[1];
        if constexpr (count > 2) s2 += q.number[2];
        if constexpr (count > 3) s3 += q.number[3];
        if constexpr (count > 4) s4 += q.number[4];
        if constexpr (count > 5) s5 += q.number[5];
        if constexpr (count > 6) s6 += q.number[6];
        if constexpr (count > 7) s7 += q.number[7];
        if constexpr (count > 8) s8 += q.number[8];
        if constexpr (count > 9) s9 += q.number[9];
        if constexpr (count > 10) s10 += q.number[10];
        if constexpr (count > 11) s11 += q.number[11];
        if constexpr (count > 12) s12 += q.number[12];
        if constexpr (count > 13) s13 += q.number[13];
        if constexpr (count > 14) s14 += q.number[14];
    }
    const Number all[]{s0, s1, s2, s3, s4, s5, s6, s7, s8, s9, s10, s11, s12, s13, s14};
    return [&]<std::size_t... c>(std::index_sequence<c...>) { return InDouble<Value>{all[c]...}; }
    (std::make_index_sequence<count>{});
}

}
