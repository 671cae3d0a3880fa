/// Packed records: position and first columns of each particle in one cache line, and their gathering into a stencil by transposes in
/// registers.
///
/// A gather instruction fetches its lanes one by one; records are loaded two columns at a time, and touch one cache line a neighbour instead of
/// one a component. Packing costs a stream over the particles a pass, about 3 % of a two-phase bed's step.
///
/// What is within the support is selected first, as indices alone, and then gathered in whole vectors. Selection and gathering in one loop
/// loads each record once, but stores every column at any offset, most of them across two cache lines: with AVX2 the force pass was 12 %
/// slower by it, with AVX-512 8 % (with the square root in the gathering loop, where it overlaps with loads and stores, in either figure).
#pragma once
#include "base/Vector.hpp"
#include "neighbours/lanes.hpp"

namespace sph
{

constexpr int recordSize = 8; ///< doubles: one cache line

namespace detail
{
/// x_i - x_j and its square of as many particles as there are lanes.
template<int dim, class L> struct Differences
{
    typename L::Doubles x[dim], sqr;

    Differences(Vector<dim> x_i, const TwoColumns<L> (&column)[2])
    {
        x[0] = x_i.x - column[0].first;
        x[1] = x_i.y - column[0].second;
        sqr = x[0] * x[0] + x[1] * x[1];
        if constexpr (dim == 3)
        {
            x[2] = x_i.z - column[1].first;
            sqr += x[2] * x[2];
        }
    }
};
}

/// Selects, of the listed particles (a multiple of 8 indices), those within the radius; `kept` needs room for 8 more. Returns their
/// number.
template<int dim, class L = WidestLanes>
inline int selectRecords(const double* records, const int* list, int n, Vector<dim> x, double radiusSqr, int* kept)
{
    const typename L::Doubles limit = L::all(radiusSqr);
    long found = 0;
#pragma GCC unroll 2 // with AVX2 the force pass gains 1 to 2 %
    for (int t = 0; t < n; t += L::count)
    {
        TwoColumns<L> column[2];
        for (int c = 0; c < dim - 1; ++c)
            column[c] = loadColumns<L>([&](int k) { return records + long(list[t + k]) * recordSize + 2 * c; });
        const unsigned bits = L::bits(L::less(detail::Differences<dim, L>(x, column).sqr, limit));
        L::store(kept + found, L::compress(L::template load<typename L::Ints>(list + t), bits));
        found += std::popcount(bits);
    }
    return int(found);
}

/// x_i - x_j, where asked for the distances, and the first nFields columns of the listed particles (a multiple of 8 indices), all within the
/// radius but for null particles at the end, which stay with x_i - x_j = 0 at twice the radius.
template<int dim, int nFields, bool distances, class L = WidestLanes, class Block>
inline void gatherRecords(const double* records, const int* list, int n, Vector<dim> x, double radiusSqr, Block& to)
{
    using Doubles = typename L::Doubles;
    const Doubles limit = L::all(radiusSqr), beyond = L::all(4 * radiusSqr);
    for (int t = 0; t < n; t += L::count)
    {
        const double* record[L::count];
        for (int k = 0; k < L::count; ++k) record[k] = records + long(list[t + k]) * recordSize;
        TwoColumns<L> column[recordSize / 2];
        for (int c = 0; c < (dim + nFields + 1) / 2; ++c) column[c] = loadColumns<L>([&](int k) { return record[k] + 2 * c; });

        const detail::Differences<dim, L> ij(x, {column[0], column[1]});
        const auto near = L::less(ij.sqr, limit);
        for (int c = 0; c < dim; ++c) L::store(&to.x[c][t], L::choose(near, ij.x[c], Doubles{}));
        if constexpr (distances) L::store(&to.r[t], L::sqrt(L::choose(near, ij.sqr, beyond)));
        for (int f = 0; f < nFields; ++f)
            L::store(&to.field[f][t], (dim + f) % 2 ? column[(dim + f) / 2].second : column[(dim + f) / 2].first);
    }
}

/// The columns of n listed particles (a multiple of 8 indices) from another packed array, of `width` doubles a particle.
template<class L = WidestLanes, class Column>
inline void gatherColumns(const double* records, int width, const int* list, int n, Column* field)
{
    for (int t = 0; t < n; t += L::count)
        for (int c = 0; c < width; c += 2)
        {
            const auto column = loadColumns<L>([&](int k) { return records + long(list[t + k]) * width + c; });
            L::store(field[c] + t, column.first);
            L::store(field[c + 1] + t, column.second);
        }
}

/// Packs `count` records, `to[i]` from element i of each of `width` arrays, an even number up to 8.
template<class L = WidestLanes> inline void packRecords(const double* const (&from)[recordSize], int width, std::size_t count, double* to)
{
    using Doubles = typename L::Doubles;
    std::size_t i = 0;
    for (; i + L::count <= count; i += L::count)
        for (int c = 0; c < width; c += 2)
            storeColumns<L>([&](int k) { return to + (i + k) * width + c; },
                            {L::template load<Doubles>(from[c] + i), L::template load<Doubles>(from[c + 1] + i)});
    for (; i < count; ++i)
        for (int c = 0; c < width; ++c) to[i * width + c] = from[c][i];
}

}
