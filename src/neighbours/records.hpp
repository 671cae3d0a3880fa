/// Packed records: position and first columns of each particle in one cache line, and their gathering into a stencil by an 8 x 8
/// transpose in registers.
///
/// A gather instruction fetches its eight lanes one by one; eight records are eight whole loads and 24 shuffles, and touch one cache
/// line a neighbour instead of one a component. What was measured is in
/// test/benchmark/README.md. Packing costs a stream over the particles a pass, about 3 % of a two-phase bed's step.
/// Without AVX-512 columns are gathered one by one.
#pragma once
#include "Vector.hpp"
#include <span>
#if defined(__AVX512F__) && defined(__AVX512VL__)
#include <immintrin.h>
#endif

namespace sph
{

constexpr int recordSize = 8; ///< doubles: one cache line

#if defined(__AVX512F__) && defined(__AVX512VL__)
constexpr bool packsRecords = true;

namespace detail
{
struct Rows
{
    __m512d row[recordSize];
};
inline Rows transposed(const Rows& a)
{
    __m512d pair[8];
    for (int k = 0; k < 8; k += 2)
    {
        pair[k] = _mm512_unpacklo_pd(a.row[k], a.row[k + 1]);
        pair[k + 1] = _mm512_unpackhi_pd(a.row[k], a.row[k + 1]);
    }
    Rows b;
    for (int odd = 0; odd < 2; ++odd)
    {
        const __m512d low0 = _mm512_shuffle_f64x2(pair[odd], pair[odd + 2], 0x88), high0 = _mm512_shuffle_f64x2(pair[odd], pair[odd + 2], 0xdd);
        const __m512d low1 = _mm512_shuffle_f64x2(pair[odd + 4], pair[odd + 6], 0x88),
                      high1 = _mm512_shuffle_f64x2(pair[odd + 4], pair[odd + 6], 0xdd);
        b.row[odd] = _mm512_shuffle_f64x2(low0, low1, 0x88);
        b.row[odd + 4] = _mm512_shuffle_f64x2(low0, low1, 0xdd);
        b.row[odd + 2] = _mm512_shuffle_f64x2(high0, high1, 0x88);
        b.row[odd + 6] = _mm512_shuffle_f64x2(high0, high1, 0xdd);
    }
    return b;
}
}

/// Of the listed particles (a multiple of 8 indices) keeps those within the radius: indices, x_i - x_j, squared distances and the first
/// nFields columns, packed; each needs room for 8 more. Returns their number. With `selects` false the list holds nothing beyond the radius
/// but null particles at its end: all stay, null particles with x_i - x_j = 0 at twice the radius.
template<int dim, int nFields, bool selects = true, class Column>
inline int gatherRecords(const double* records, const int* list, int n, Vector<dim> x, double radiusSqr, long* j, Column (&xij)[dim],
                         double* rSqr, Column* field)
{
    int found = 0;
    const __m512d limit = _mm512_set1_pd(radiusSqr);
    [[maybe_unused]] const __m512d beyond = _mm512_set1_pd(4*radiusSqr);
    const auto keep = [&](double* to, __mmask8 near, __m512d q)
    {
        if constexpr (selects) _mm512_storeu_pd(to + found, _mm512_maskz_compress_pd(near, q));
        else _mm512_store_pd(to + found, q);
    };
    for (int t = 0; t < n; t += 8)
    {
        detail::Rows rows;
        for (int k = 0; k < 8; ++k) rows.row[k] = _mm512_load_pd(records + std::size_t(list[t + k])*recordSize);
        const detail::Rows column = detail::transposed(rows);
        __m512d dx = _mm512_set1_pd(x.x) - column.row[0], dy = _mm512_set1_pd(x.y) - column.row[1], dz{}, r2 = dx*dx + dy*dy;
        if constexpr (dim == 3)
        {
            dz = _mm512_set1_pd(x.z) - column.row[2];
            r2 += dz*dz;
        }
        const __mmask8 near = _mm512_cmp_pd_mask(r2, limit, _CMP_LT_OQ);
        if constexpr (!selects)
        {
            dx = _mm512_maskz_mov_pd(near, dx);
            dy = _mm512_maskz_mov_pd(near, dy);
            dz = _mm512_maskz_mov_pd(near, dz);
            r2 = _mm512_mask_mov_pd(beyond, near, r2);
        }
        keep(xij[0], near, dx);
        keep(xij[1], near, dy);
        if constexpr (dim == 3) keep(xij[2], near, dz);
        keep(rSqr, near, r2);
        const __m512i index = _mm512_cvtepi32_epi64(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(list + t)));
        if constexpr (selects) _mm512_storeu_si512(j + found, _mm512_maskz_compress_epi64(near, index));
        else _mm512_store_si512(j + found, index);
        for (int f = 0; f < nFields; ++f) keep(field[f], near, column.row[dim + f]);
        found += selects ? __builtin_popcount(near) : 8;
    }
    return found;
}

/// Eight further columns of n particles (a multiple of 8 indices) from another packed array.
template<class Column> inline void gatherColumns(const double* records, const long* j, int n, Column* field)
{
    for (int t = 0; t < n; t += 8)
    {
        detail::Rows rows;
        for (int k = 0; k < 8; ++k) rows.row[k] = _mm512_load_pd(records + j[t + k]*recordSize);
        const detail::Rows column = detail::transposed(rows);
        for (int f = 0; f < recordSize; ++f) _mm512_store_pd(field[f] + t, column.row[f]);
    }
}

/// Packs `count` records, `to[i]` from element i of each of the 8 arrays.
inline void packRecords(const double* const (&from)[recordSize], std::size_t count, double* to)
{
    std::size_t i = 0;
    for (; i + 8 <= count; i += 8)
    {
        detail::Rows column;
        for (int c = 0; c < recordSize; ++c) column.row[c] = _mm512_loadu_pd(from[c] + i);
        const detail::Rows rows = detail::transposed(column);
        for (int k = 0; k < 8; ++k) _mm512_store_pd(to + (i + k)*recordSize, rows.row[k]);
    }
    for (; i < count; ++i)
        for (int c = 0; c < recordSize; ++c) to[i*recordSize + c] = from[c][i];
}
#else
constexpr bool packsRecords = false;

template<class Column> inline void gatherColumns(const double*, const long*, int, Column*) {}
inline void packRecords(const double* const (&)[recordSize], std::size_t, double*) {}

template<int dim, int nFields, bool selects = true, class Column>
inline int gatherRecords(const double*, const int*, int, Vector<dim>, double, long*, Column (&)[dim], double*, Column*)
{
    return 0;
}
#endif

}
