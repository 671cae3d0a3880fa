/// Packed records: position and first columns of each particle in one cache line, and their gathering into a stencil by transposes in
/// registers.
///
/// A gather instruction fetches its lanes one by one; records are loaded two columns at a time, and touch one cache line a neighbour instead of
/// one a component. What was measured is in test/benchmark/README.md. Packing costs a stream over the particles a pass, about 3 % of a
/// two-phase bed's step.
#pragma once
#include "Vector.hpp"
#include "lanes.hpp"

namespace sph
{

constexpr int recordSize = 8; ///< doubles: one cache line

/// Of the listed particles (a multiple of 8 indices) keeps those within the radius: indices, x_i - x_j, squared distances and the first
/// nFields columns, packed; each needs room for 8 more. Returns their number. With `selects` false the list holds nothing beyond the radius
/// but null particles at its end: all stay, null particles with x_i - x_j = 0 at twice the radius.
template<int dim, int nFields, bool selects = true, class L = WidestLanes, class Column>
inline int gatherRecords(const double* records, const int* list, int n, Vector<dim> x, double radiusSqr, long* j, Column (&xij)[dim],
                         double* rSqr, Column* field)
{
    using Doubles = typename L::Doubles;
    const Doubles limit = L::all(radiusSqr), beyond = L::all(4*radiusSqr);
    int found = 0;
    for (int t = 0; t < n; t += L::count)
    {
        TwoColumns<L> column[recordSize/2];
        for (int c = 0; c < (dim + nFields + 1)/2; ++c)
            column[c] = loadColumns<L>([&](int k) { return records + std::size_t(list[t + k])*recordSize + 2*c; });

        Doubles dx = x.x - column[0].first, dy = x.y - column[0].second, dz{}, r2 = dx*dx + dy*dy;
        if constexpr (dim == 3)
        {
            dz = x.z - column[1].first;
            r2 += dz*dz;
        }
        const auto near = L::less(r2, limit);
        const unsigned bits = L::bits(near);
        const auto keep = [&](auto* to, auto q)
        {
            if constexpr (selects) L::store(to + found, L::compress(q, bits));
            else L::store(to + found, q);
        };
        if constexpr (!selects)
        {
            dx = L::choose(near, dx, Doubles{});
            dy = L::choose(near, dy, Doubles{});
            dz = L::choose(near, dz, Doubles{});
            r2 = L::choose(near, r2, beyond);
        }
        keep(xij[0], dx);
        keep(xij[1], dy);
        if constexpr (dim == 3) keep(xij[2], dz);
        keep(rSqr, r2);
        keep(j, L::widened(L::template load<typename L::Ints>(list + t)));
        for (int f = 0; f < nFields; ++f) keep(field[f], (dim + f)%2 ? column[(dim + f)/2].second : column[(dim + f)/2].first);
        found += selects ? std::popcount(bits) : L::count;
    }
    return found;
}

/// Eight further columns of n particles (a multiple of 8 indices) from another packed array.
template<class L = WidestLanes, class Column> inline void gatherColumns(const double* records, const long* j, int n, Column* field)
{
    for (int t = 0; t < n; t += L::count)
        for (int c = 0; c < recordSize; c += 2)
        {
            const auto column = loadColumns<L>([&](int k) { return records + j[t + k]*recordSize + c; });
            L::store(field[c] + t, column.first);
            L::store(field[c + 1] + t, column.second);
        }
}

/// Packs `count` records, `to[i]` from element i of each of the 8 arrays.
template<class L = WidestLanes> inline void packRecords(const double* const (&from)[recordSize], std::size_t count, double* to)
{
    using Doubles = typename L::Doubles;
    std::size_t i = 0;
    for (; i + L::count <= count; i += L::count)
        for (int c = 0; c < recordSize; c += 2)
            storeColumns<L>([&](int k) { return to + (i + k)*recordSize + c; },
                            {L::template load<Doubles>(from[c] + i), L::template load<Doubles>(from[c + 1] + i)});
    for (; i < count; ++i)
        for (int c = 0; c < recordSize; ++c) to[i*recordSize + c] = from[c][i];
}

}
