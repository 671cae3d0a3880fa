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
#include "base/values.hpp"
#include "neighbours/lanes.hpp"
#include <algorithm>

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
template<class L = WidestLanes> inline void packRecords(const double* const* from, int width, std::size_t count, double* to)
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

/// Numbers of four bytes in a record of single precision, places as integers and columns as floats: a power of two from 4 on, so that none of up to 64 bytes lies in two
/// cache lines.
template<int dim> constexpr int singleRecordSize(int columnCount) { return std::max(4, int(std::bit_ceil(unsigned(dim + columnCount)))); }

/// Places in records of single precision are multiples of 2^-30 of the domain's extent from its centre on; they are as fine everywhere, differ exactly, and those of
/// periodic images by 2^30. The null particle, beyond all integers, is the least of them, and farther than the extent from what lies in the domain.
template<int dim> struct PlaceUnits
{
    double centre[dim], unit[dim]; ///< [m]

    PlaceUnits(Vector<dim> low, Vector<dim> high)
    {
        store(0.5 * (low + high), [&](int c, double q) { centre[c] = q; });
        store(high - low, [&](int c, double q) { unit[c] = std::ldexp(q, -30); });
    }
};

namespace detail
{
/// x_i - x_j of a particle in single precision.
template<int dim, class Wide> struct SingleDifferences
{
    int place[dim];
    float unit[dim];

    SingleDifferences(const PlaceUnits<dim>& units, const float* record)
    {
        for (int c = 0; c < dim; ++c)
        {
            place[c] = std::bit_cast<int>(record[c]);
            unit[c] = float(units.unit[c]);
        }
    }
    /// Component c, of records whose first four columns are given.
    auto operator()(int c, const FourColumns<Wide>& first) const
    {
        return Wide::asFloats(place[c] - std::bit_cast<typename Wide::Ints>(first.column[c])) * unit[c];
    }
};

template<int dim, int groups, class L, class Block>
[[gnu::flatten]] inline int gatherSingleRecordsOf(const float* records, const PlaceUnits<dim>& units, int particle, const int* list, int n,
                                                  Block& to)
{
    using Wide = FloatLanes<2 * L::count>;
    constexpr int size = std::bit_ceil(4u * groups);
    const SingleDifferences<dim, Wide> difference(units, records + long(particle) * size);
    int t = 0;
    const auto gather = [&](const auto& at)
    {
        const auto first = loadFourColumns<Wide>([&](int k) { return records + long(at(k)) * size; });
        for (int c = 0; c < dim; ++c) Wide::store(&to.x[c][t], difference(c, first));
        for (int c = dim; c < 4; ++c) Wide::store(&to.field[c - dim][t], first.column[c]);
        for (int c = 4; c < 4 * groups; c += 4)
        {
            const auto next = loadFourColumns<Wide>([&](int k) { return records + long(at(k)) * size + c; });
            for (int k = 0; k < 4; ++k) Wide::store(&to.field[c - dim + k][t], next.column[k]);
        }
    };
    for (; t + Wide::count <= n; t += Wide::count) gather([&](int k) { return list[t + k]; });
    if (t < n)
    {
        gather([&](int k) { return list[std::min(t + k, n - 1)]; });
        t += Wide::count;
    }
    return t;
}
}

/// Selects, of the listed particles (a multiple of 8 indices), those within the radius, as `selectRecords`.
template<int dim, class L = WidestLanes>
[[gnu::flatten]] inline int selectSingleRecords(const float* records, int columnCount, const PlaceUnits<dim>& units, int particle,
                                                const int* list, int n, double radius, int* kept)
{
    using Wide = FloatLanes<2 * L::count>;
    const long size = singleRecordSize<dim>(columnCount);
    const detail::SingleDifferences<dim, Wide> difference(units, records + particle * size);
    const auto limit = float(sqr(radius)) - typename Wide::Floats{};
    long found = 0;
    const auto within = [&](const auto& listed)
    {
        const auto first = loadFourColumns<Wide>([&](int k) { return records + listed(k) * size; });
        auto square = difference(0, first) * difference(0, first);
        for (int c = 1; c < dim; ++c) square += difference(c, first) * difference(c, first);
        return Wide::less(square, limit);
    };
    int t = 0;
    for (; t + Wide::count <= n; t += Wide::count)
        found += Wide::append(kept + found, list + t, within([&](int k) { return list[t + k]; }));
    constexpr unsigned all = (1u << L::count) - 1;
    if (t < n)
    {
        const unsigned bits = within([&](int k) { return list[t + k % L::count]; }) & all;
        L::store(kept + found, L::compress(L::template load<typename L::Ints>(list + t), bits));
        found += std::popcount(bits);
    }
    return int(found);
}

/// x_i - x_j and all columns of the n listed particles (a multiple of 8 indices) from records of single precision, as singles. Returns the number of entries, a multiple of the lanes:
/// those behind the listed ones repeat the last. The null particle at the end of a list has any finite x_i - x_j.
template<int dim, class L = WidestLanes, class Block>
inline int gatherSingleRecords(const float* records, int columnCount, const PlaceUnits<dim>& units, int particle, const int* list, int n,
                               Block& to)
{
    const auto inGroups = [&](auto groups)
    { return detail::gatherSingleRecordsOf<dim, groups(), L>(records, units, particle, list, n, to); };
    switch ((dim + columnCount + 3) / 4)
    {
    case 1:
        return inGroups(std::integral_constant<int, 1>{});
    case 2:
        return inGroups(std::integral_constant<int, 2>{});
    case 3:
        return inGroups(std::integral_constant<int, 3>{});
    case 4:
        return inGroups(std::integral_constant<int, 4>{});
    case 5:
    case 6:
        return inGroups(std::integral_constant<int, 6>{});
    case 7:
    case 8:
        return inGroups(std::integral_constant<int, 8>{});
    default:
        return inGroups(std::integral_constant<int, 11>{});
    }
}

/// Packs `count` records of so many columns, `to[i]` from element i of each coordinate and column, of as many arrays as a record has numbers.
template<int dim, class L = WidestLanes>
inline void packSingleRecords(const double* const* from, int columnCount, const PlaceUnits<dim>& units, std::size_t count, float* to)
{
    const int size = singleRecordSize<dim>(columnCount);
    double perUnit[dim];
    for (int c = 0; c < dim; ++c) perUnit[c] = 1 / units.unit[c];
    const auto asPlace = [&](int c, auto x) { return (x - units.centre[c]) * perUnit[c]; };
    std::size_t i = 0;
    for (; i + L::count <= count; i += L::count)
        for (int c = 0; c < size; c += 4)
        {
            const auto column = [&](int k)
            {
                const auto q = L::template load<typename L::Doubles>(from[c + k] + i);
                return c + k < dim ? std::bit_cast<typename L::Floats>(L::rounded(asPlace(c + k, q))) : L::narrowed(q);
            };
            storeFourColumns<L>([&](int k) { return to + (i + k) * size + c; }, {{column(0), column(1), column(2), column(3)}});
        }
    for (; i < count; ++i)
        for (int c = 0; c < size; ++c)
        {
            const double q = from[c][i];
            to[i * size + c] = c < dim ? std::bit_cast<float>(detail::rounded(asPlace(c, q))) : float(q);
        }
}

}
