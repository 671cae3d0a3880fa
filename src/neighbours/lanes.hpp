/// Vectors of 8, 4 or 2 doubles with what the compiler does not find by itself: selection into the first lanes (compress) and
/// transposes. Loops over them are written once, for any number of lanes.
///
/// Arithmetic is that of GCC's vector types; only what they lack is named by its instruction. 8 lanes need AVX-512, 4 lanes AVX2, 2 lanes no
/// particular instruction set. A build has every width up to the widest of its instruction set, so that tests compare all of them.
/// Highway 1.0.3 (Debian 12) was tried in place of this file: GCC 12 copies its table of permutations to the stack at every compress, which
/// took the force pass from 0.65 to 0.16 of the pair limit with AVX-512; and plain x86-64 has one lane in it.
#pragma once
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>
#if defined(__AVX2__)
#include <immintrin.h>
#endif

namespace sph
{

namespace detail
{
/// Layout of the codes of indices (IndexPages.hpp): the upper 4 bits name a page, the lower 12 a place in it.
inline constexpr int pageBits = 12, pageSize = 1 << pageBits, pageCount = 16;

/// Vectors of any width; a better form of an instruction set hides one of these functions by the same name.
template<int lanes> struct AnyLanes
{
    typedef double Doubles __attribute__((vector_size(8 * lanes)));
    typedef float Floats __attribute__((vector_size(4 * lanes)));
    typedef long Longs __attribute__((vector_size(8 * lanes)));
    typedef int Ints __attribute__((vector_size(4 * lanes)));
    using Mask = Longs;
    static constexpr int count = lanes;

    template<class V, class T> static V load(const T* from)
    {
        V v;
        std::memcpy(&v, from, sizeof v);
        return v;
    }
    template<class V, class T> static void store(T* to, V v) { std::memcpy(to, &v, sizeof v); }
    static Doubles all(double q) { return q - Doubles{}; }

    static Mask less(Doubles a, Doubles b) { return a < b; }
    static Doubles choose(Mask mask, Doubles a, Doubles b) { return mask ? a : b; }
    static void unpack(const std::uint16_t* codes, const int* pages, int* to)
    {
        for (int k = 0; k < 8; ++k) to[k] = pages[codes[k] >> pageBits] + codes[k] % pageSize;
    }

    /// a_0 b_0 a_2 b_2 ... and a_1 b_1 a_3 b_3 ...
    static Doubles evenOf(Doubles a, Doubles b) { return interleaved<0>(a, b, std::make_integer_sequence<int, lanes>{}); }
    static Doubles oddOf(Doubles a, Doubles b) { return interleaved<1>(a, b, std::make_integer_sequence<int, lanes>{}); }

private:
    template<int odd, int... k> static Doubles interleaved(Doubles a, Doubles b, std::integer_sequence<int, k...>)
    {
        return __builtin_shufflevector(a, b, (k / 2 * 2 + odd + k % 2 * lanes)...);
    }
};

/// The nearest whole number, or the least of all integers where it is none of them.
inline int rounded(double q)
{
    constexpr double limit = 1L << 31;
    const double whole = std::nearbyint(q);
    return whole >= -limit && whole < limit ? int(whole) : std::numeric_limits<int>::min();
}

/// Order in which a compress leaves the lanes, for each set of kept ones; a lane has so many `parts`.
template<int lanes, int parts, class Index = int> constexpr auto compressOrders()
{
    std::array<std::array<Index, lanes * parts>, 1 << lanes> orders{};
    for (int set = 0; set < 1 << lanes; ++set)
        for (int lane = 0, to = 0; lane < lanes; ++lane)
            if (set >> lane & 1)
                for (int part = 0; part < parts; ++part) orders[set][to++] = Index(lane * parts + part);
    return orders;
}
}

/// `widened` integers or floats are as many of twice the size, `narrowed` does the reverse; `rounded` doubles are the nearest integers, or the least of all
/// where there is none.
/// `bits` of a mask: one a lane, the first the lowest. `compress` moves the lanes of these bits to the front; what follows them is undefined.
/// `loadPairs` joins the two doubles at each of at(0), at(1) ..., storePairs does the reverse. `unpack` makes
/// 8 indices of their codes.
template<int lanes> struct Lanes;

template<> struct Lanes<2> : detail::AnyLanes<2>
{
    static Longs widened(Ints v) { return __builtin_convertvector(v, Longs); }
    static Doubles widened(Floats v) { return Doubles{v[0], v[1]}; }
    static Ints rounded(Doubles v) { return Ints{detail::rounded(v[0]), detail::rounded(v[1])}; }
    static Floats narrowed(Doubles v) { return Floats{float(v[0]), float(v[1])}; }
    static unsigned bits(Mask m) { return unsigned(m[0] & 1) | unsigned(m[1] & 2); }
    static Doubles sqrt(Doubles v) { return Doubles{__builtin_sqrt(v[0]), __builtin_sqrt(v[1])}; }
    template<class V> static V compress(V v, unsigned bits) { return V{bits & 1 ? v[0] : v[1], v[1]}; }
    template<class At> static Doubles loadPairs(const At& at) { return load<Doubles>(at(0)); }
    template<class At> static void storePairs(const At& at, Doubles v) { store(at(0), v); }
};

#if defined(__AVX2__)
template<> struct Lanes<4> : detail::AnyLanes<4>
{
    static Longs widened(Ints v) { return Longs(_mm256_cvtepi32_epi64(__m128i(v))); }
    static Doubles widened(Floats v) { return _mm256_cvtps_pd(v); }
    static Ints rounded(Doubles v) { return Ints(_mm256_cvtpd_epi32(v)); }
    static Floats narrowed(Doubles v) { return _mm256_cvtpd_ps(v); }
    static unsigned bits(Mask m) { return unsigned(_mm256_movemask_pd(__m256d(m))); }
    static Doubles sqrt(Doubles v) { return _mm256_sqrt_pd(v); }
    static Ints compress(Ints v, unsigned bits) { return Ints(_mm_permutevar_ps(__m128(v), load<__m128i>(&orders[bits]))); }
    template<class V> static V compress(V v, unsigned bits)
    {
        return V(_mm256_permutevar8x32_epi32(__m256i(v), _mm256_load_si256(reinterpret_cast<const __m256i*>(&halfOrders[bits]))));
    }
    template<class At> static Doubles loadPairs(const At& at)
    {
        return _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(at(0))), _mm_loadu_pd(at(1)), 1);
    }
    template<class At> static void storePairs(const At& at, Doubles v)
    {
        _mm_storeu_pd(at(0), _mm256_castpd256_pd128(v));
        _mm_storeu_pd(at(1), _mm256_extractf128_pd(v, 1));
    }
    static void unpack(const std::uint16_t* codes, const int* pages, int* to)
    {
        const __m256i code = _mm256_cvtepu16_epi32(load<__m128i>(codes)), page = _mm256_srli_epi32(code, detail::pageBits);
        const auto half = [&](int k) { return __m256(_mm256_permutevar8x32_epi32(load<__m256i>(pages + k), page)); };
        // The highest bit of a code is that of the upper half.
        const auto first = __m256i(_mm256_blendv_ps(half(0), half(8), __m256(_mm256_slli_epi32(code, 16))));
        store(to, _mm256_add_epi32(first, _mm256_and_si256(code, _mm256_set1_epi32(detail::pageSize - 1))));
    }

private:
    alignas(16) static constexpr auto orders = detail::compressOrders<4, 1>();
    alignas(32) static constexpr auto halfOrders = detail::compressOrders<4, 2>();
};
#endif

#if defined(__AVX512F__) && defined(__AVX512VL__)
template<> struct Lanes<8> : detail::AnyLanes<8>
{
    using Mask = __mmask8;
    static Mask less(Doubles a, Doubles b) { return _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ); }
    static Doubles choose(Mask mask, Doubles a, Doubles b) { return _mm512_mask_mov_pd(b, mask, a); }
    static Longs widened(Ints v) { return Longs(_mm512_cvtepi32_epi64(__m256i(v))); }
    static Doubles widened(Floats v) { return _mm512_cvtps_pd(v); }
    static Ints rounded(Doubles v) { return Ints(_mm512_cvtpd_epi32(v)); }
    static Floats narrowed(Doubles v) { return _mm512_cvtpd_ps(v); }
    static unsigned bits(Mask m) { return m; }
    static Doubles sqrt(Doubles v) { return _mm512_sqrt_pd(v); }
    static Doubles compress(Doubles v, unsigned bits) { return _mm512_maskz_compress_pd(Mask(bits), v); }
    static Longs compress(Longs v, unsigned bits) { return Longs(_mm512_maskz_compress_epi64(Mask(bits), __m512i(v))); }
    static Ints compress(Ints v, unsigned bits) { return Ints(_mm256_maskz_compress_epi32(Mask(bits), __m256i(v))); }
    template<class At> static Doubles loadPairs(const At& at)
    {
        const auto four = [&](int k) { return Lanes<4>::loadPairs([&](int b) { return at(k + b); }); };
        return _mm512_insertf64x4(_mm512_castpd256_pd512(four(0)), four(2), 1);
    }
    template<class At> static void storePairs(const At& at, Doubles v)
    {
        Lanes<4>::storePairs(at, _mm512_castpd512_pd256(v));
        Lanes<4>::storePairs([&](int b) { return at(2 + b); }, _mm512_extractf64x4_pd(v, 1));
    }
    static void unpack(const std::uint16_t* codes, const int* pages, int* to)
    {
        const __m256i code = _mm256_cvtepu16_epi32(load<__m128i>(codes)), page = _mm256_srli_epi32(code, detail::pageBits),
                      first = _mm256_permutex2var_epi32(load<__m256i>(pages), page, load<__m256i>(pages + 8));
        store(to, _mm256_add_epi32(first, _mm256_and_si256(code, _mm256_set1_epi32(detail::pageSize - 1))));
    }
};
using WidestLanes = Lanes<8>;
#elif defined(__AVX2__)
using WidestLanes = Lanes<4>;
#else
using WidestLanes = Lanes<2>;
#endif

/// Two columns next to one another of as many rows as there are lanes, at(k) the address of row k in the first of them.
template<class L> struct TwoColumns
{
    typename L::Doubles first, second;
};
template<class L, class At> TwoColumns<L> loadColumns(const At& at)
{
    const auto even = L::loadPairs([&](int k) { return at(2 * k); }), odd = L::loadPairs([&](int k) { return at(2 * k + 1); });
    return {L::evenOf(even, odd), L::oddOf(even, odd)};
}
template<class L, class At> void storeColumns(const At& at, TwoColumns<L> columns)
{
    L::storePairs([&](int k) { return at(2 * k); }, L::evenOf(columns.first, columns.second));
    L::storePairs([&](int k) { return at(2 * k + 1); }, L::oddOf(columns.first, columns.second));
}

#if defined(__AVX2__)
namespace detail
{
inline constexpr auto ordersOfEight = compressOrders<8, 1, std::uint8_t>();
}
#endif

/// Vectors of 4, 8 or 16 floats.
template<int lanes> struct FloatLanes
{
    typedef float Floats __attribute__((vector_size(4 * lanes)));
    typedef int Ints __attribute__((vector_size(4 * lanes)));
    static constexpr int count = lanes;
    static void store(auto* to, Floats v) { std::memcpy(static_cast<void*>(to), &v, sizeof v); }
    static Floats asFloats(auto v) { return __builtin_convertvector(v, Floats); }
    /// One bit a lane, the first the lowest, set where a < b.
    static unsigned less(auto a, auto b)
    {
#if defined(__AVX512F__)
        if constexpr (lanes == 16) return _mm512_cmp_ps_mask(__m512(a), __m512(b), _CMP_LT_OQ);
#endif
#if defined(__AVX2__)
        if constexpr (lanes == 8) return unsigned(_mm256_movemask_ps(_mm256_cmp_ps(__m256(a), __m256(b), _CMP_LT_OQ)));
#endif
        unsigned all = 0;
        for (int k = 0; k < lanes; ++k) all |= unsigned(a[k] < b[k]) << k;
        return all;
    }
    /// Writes those of the integers whose bit is set, next to one another, and returns their number; `to` needs room for all.
    static int append(int* to, const int* from, unsigned bits)
    {
#if defined(__AVX512F__)
        if constexpr (lanes == 16)
        {
            _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(__mmask16(bits), _mm512_loadu_si512(from)));
            return std::popcount(bits);
        }
        else
#endif
#if defined(__AVX2__)
            if constexpr (lanes == 8)
        {
            const auto order = _mm256_cvtepu8_epi32(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(&detail::ordersOfEight[bits])));
            _mm256_storeu_si256(reinterpret_cast<__m256i*>(to),
                                _mm256_permutevar8x32_epi32(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(from)), order));
            return std::popcount(bits);
        }
        else
#endif
        {
            using Half = Lanes<lanes / 2>;
            int n = 0;
            for (int k = 0; k < 2; ++k)
            {
                const unsigned ofHalf = bits >> k * Half::count & ((1u << Half::count) - 1);
                Half::store(to + n, Half::compress(Half::template load<typename Half::Ints>(from + k * Half::count), ofHalf));
                n += std::popcount(ofHalf);
            }
            return n;
        }
    }
};

/// Four columns next to one another of as many rows of floats as there are lanes, at(k) the address of row k in the first of them.
template<class L> struct FourColumns
{
    typename L::Floats column[4];
};

namespace detail
{
typedef float FourFloats __attribute__((vector_size(16)));
inline FourFloats loadFour(const float* from)
{
    FourFloats v;
    std::memcpy(&v, from, sizeof v);
    return v;
}

/// The rows of four floats at(k), and at(k + 4) ... behind it where a vector holds more than one.
template<class L, class At> typename L::Floats rowsOf(const At& at, int k)
{
#if defined(__AVX512F__)
    if constexpr (L::count == 16)
    {
        auto rows = _mm512_castps128_ps512(_mm_loadu_ps(at(k)));
        rows = _mm512_insertf32x4(rows, _mm_loadu_ps(at(k + 4)), 1);
        rows = _mm512_insertf32x4(rows, _mm_loadu_ps(at(k + 8)), 2);
        return _mm512_insertf32x4(rows, _mm_loadu_ps(at(k + 12)), 3);
    }
#endif
#if defined(__AVX2__)
    if constexpr (L::count == 8) return _mm256_insertf128_ps(_mm256_castps128_ps256(_mm_loadu_ps(at(k))), _mm_loadu_ps(at(k + 4)), 1);
#endif
    if constexpr (L::count == 4) return loadFour(at(k));
}
template<class L, class At> void storeRowsOf(const At& at, int k, typename L::Floats rows)
{
    std::memcpy(at(k), &rows, sizeof(FourFloats));
    if constexpr (L::count == 8) std::memcpy(at(k + 4), reinterpret_cast<const char*>(&rows) + sizeof(FourFloats), sizeof(FourFloats));
}

/// Of each four floats of two vectors `alternating` makes a_0 b_0 a_1 b_1 (half 0) or a_2 b_2 a_3 b_3 (half 1), `joined` a_0 a_1 b_0 b_1 or a_2 a_3 b_2 b_3.
template<int half, class V, int... k> V alternating(V a, V b, std::integer_sequence<int, k...>)
{
    return __builtin_shufflevector(a, b, (k / 4 * 4 + 2 * half + k % 4 / 2 + k % 2 * int(sizeof...(k)))...);
}
template<int half, class V, int... k> V joined(V a, V b, std::integer_sequence<int, k...>)
{
    return __builtin_shufflevector(a, b, (k / 4 * 4 + 2 * half + k % 2 + k % 4 / 2 * int(sizeof...(k)))...);
}
/// Rows of columns, or columns of rows: transposes of four by four in each part of 16 bytes.
template<class L> FourColumns<L> transposed(const FourColumns<L>& of)
{
    constexpr std::make_integer_sequence<int, L::count> all;
    const auto& [a, b, c, d] = of.column;
    const auto ab = alternating<0>(a, b, all), cd = alternating<0>(c, d, all), restOfAb = alternating<1>(a, b, all),
               restOfCd = alternating<1>(c, d, all);
    return {{joined<0>(ab, cd, all), joined<1>(ab, cd, all), joined<0>(restOfAb, restOfCd, all), joined<1>(restOfAb, restOfCd, all)}};
}
}

template<class L, class At> FourColumns<L> loadFourColumns(const At& at)
{
    if constexpr (L::count == 2)
    {
        FourColumns<L> columns;
        for (int c = 0; c < 4; ++c) columns.column[c] = typename L::Floats{at(0)[c], at(1)[c]};
        return columns;
    }
    else
        return detail::transposed<L>(
            {{detail::rowsOf<L>(at, 0), detail::rowsOf<L>(at, 1), detail::rowsOf<L>(at, 2), detail::rowsOf<L>(at, 3)}});
}
template<class L, class At> void storeFourColumns(const At& at, const FourColumns<L>& columns)
{
    if constexpr (L::count == 2)
    {
        for (int k = 0; k < 2; ++k)
            for (int c = 0; c < 4; ++c) at(k)[c] = columns.column[c][k];
    }
    else
    {
        const auto rows = detail::transposed<L>(columns);
        for (int k = 0; k < 4; ++k) detail::storeRowsOf<L>(at, k, rows.column[k]);
    }
}

}
