/// Keeps of a run of candidates those within a radius: the inner loop of list building and of the stencil's fill.
///
/// GCC 12 does not vectorise a loop that appends. With AVX-512 the compress instruction does it, in registers (its form that writes
/// to memory is slow on some machines); elsewhere a scalar loop without branches.
#pragma once
#include "Vector.hpp"
#if defined(__AVX512F__) && defined(__AVX512VL__)
#include <immintrin.h>
#endif

namespace sph
{

/// Writes order[b] for every b in [begin, end) with |x_b - x| < radius to `out` and returns their number. `out` needs room for 8 more.
template<int dim>
inline int selectWithin(const double* const (&position)[dim], const int* order, int begin, int end, Vector<dim> x, double radiusSqr,
                        int* out)
{
    int found = 0;
    int b = begin;
#if defined(__AVX512F__) && defined(__AVX512VL__)
    const __m512d limit = _mm512_set1_pd(radiusSqr);
    for (; b < end; b += 8)
    {
        const __mmask8 lanes = end - b >= 8 ? 0xff : __mmask8((1 << (end - b)) - 1);
        const __m512d dx = _mm512_maskz_loadu_pd(lanes, position[0] + b) - _mm512_set1_pd(x.x);
        const __m512d dy = _mm512_maskz_loadu_pd(lanes, position[1] + b) - _mm512_set1_pd(x.y);
        __m512d rSqr = dx*dx + dy*dy;
        if constexpr (dim == 3)
        {
            const __m512d dz = _mm512_maskz_loadu_pd(lanes, position[2] + b) - _mm512_set1_pd(x.z);
            rSqr += dz*dz;
        }
        const __mmask8 near = _mm512_mask_cmp_pd_mask(lanes, rSqr, limit, _CMP_LT_OQ);
        _mm256_storeu_si256(reinterpret_cast<__m256i*>(out + found),
                            _mm256_maskz_compress_epi32(near, _mm256_maskz_loadu_epi32(lanes, order + b)));
        found += __builtin_popcount(near);
    }
#else
    for (; b < end; ++b)
    {
        double rSqr = sqr(position[0][b] - x.x) + sqr(position[1][b] - x.y);
        if constexpr (dim == 3) rSqr += sqr(position[2][b] - x.z);
        out[found] = order[b];
        found += rSqr < radiusSqr;
    }
#endif
    return found;
}

/// Of the listed particles (a multiple of 8 indices) keeps those within the radius: indices, x_i - x_j and squared distances, packed
/// into `j`, `xij`, `rSqr`, which need room for 8 more. Returns their number.
template<int dim, class Column>
inline int gatherWithin(const double* const (&position)[dim], const int* list, int n, Vector<dim> x, double radiusSqr, long* j,
                        Column (&xij)[dim], double* rSqr)
{
    int found = 0;
#if defined(__AVX512F__) && defined(__AVX512VL__)
    const __m512d limit = _mm512_set1_pd(radiusSqr);
    for (int t = 0; t < n; t += 8)
    {
        const __m256i index = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(list + t));
        const __m512d dx = _mm512_set1_pd(x.x) - _mm512_i32gather_pd(index, position[0], 8);
        const __m512d dy = _mm512_set1_pd(x.y) - _mm512_i32gather_pd(index, position[1], 8);
        __m512d dz{}, r2 = dx*dx + dy*dy;
        if constexpr (dim == 3)
        {
            dz = _mm512_set1_pd(x.z) - _mm512_i32gather_pd(index, position[2], 8);
            r2 += dz*dz;
        }
        const __mmask8 near = _mm512_cmp_pd_mask(r2, limit, _CMP_LT_OQ);
        _mm512_storeu_pd(xij[0] + found, _mm512_maskz_compress_pd(near, dx));
        _mm512_storeu_pd(xij[1] + found, _mm512_maskz_compress_pd(near, dy));
        if constexpr (dim == 3) _mm512_storeu_pd(xij[2] + found, _mm512_maskz_compress_pd(near, dz));
        _mm512_storeu_pd(rSqr + found, _mm512_maskz_compress_pd(near, r2));
        _mm512_storeu_si512(j + found, _mm512_maskz_compress_epi64(near, _mm512_cvtepi32_epi64(index)));
        found += __builtin_popcount(near);
    }
#else
    for (int t = 0; t < n; ++t)
    {
        const int k = list[t];
        xij[0][found] = x.x - position[0][k];
        xij[1][found] = x.y - position[1][k];
        double r2 = sqr(xij[0][found]) + sqr(xij[1][found]);
        if constexpr (dim == 3)
        {
            xij[2][found] = x.z - position[2][k];
            r2 += sqr(xij[2][found]);
        }
        rSqr[found] = r2;
        j[found] = k;
        found += r2 < radiusSqr;
    }
#endif
    return found;
}

}
