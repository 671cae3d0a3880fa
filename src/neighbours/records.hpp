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

/// Numbers of four bytes in a record of single precision, places as integers and columns as floats: a power of two, so that none of up to 64 bytes lies in two
/// cache lines.
template<int dim> constexpr int singleRecordSize(int columnCount) { return int(std::bit_ceil(unsigned(dim + columnCount))); }

/// What the numbers of records in single precision are multiples of. Places: 2^-30 of the domain's extent from its centre on; they are as fine everywhere, differ exactly, and those of
/// periodic images by 2^30. Columns: powers of two near their values, since floats end at 1e-38, and V^2 of particles of 1 um is 1e-36 m^6.
template<int dim> struct SingleUnits
{
    static constexpr int most = 64;
    double centre[dim]; ///< of the domain [m]
    double unit[most], perUnit[most];

    SingleUnits(Vector<dim> low, Vector<dim> high)
    {
        std::fill_n(unit, most, 1);
        std::fill_n(perUnit, most, 1);
        store(0.5 * (low + high), [&](int c, double q) { centre[c] = q; });
        store(high - low, [&](int c, double q) { set(c, std::ldexp(q, -30)); });
    }
    /// Number c of a record has values of about this size.
    void setScale(int c, double size)
    {
        int exponent;
        std::frexp(size, &exponent);
        set(c, size > 0 && std::isfinite(size) ? std::ldexp(1, std::clamp(exponent, -1000, 1000)) : 1);
    }

private:
    void set(int c, double q)
    {
        unit[c] = q;
        perUnit[c] = 1 / q;
    }
};

/// x_i - x_j and all columns of the listed particles (a multiple of 8 indices) from records of single precision. The null particle at the end of a list has any finite
/// x_i - x_j.
template<int dim, class L = WidestLanes, class Block>
inline void gatherSingleRecords(const float* records, int columnCount, const SingleUnits<dim>& units, int particle, const int* list, int n,
                                Block& to)
{
    using Ints = typename L::Ints;
    const int size = singleRecordSize<dim>(columnCount);
    double place[dim];
    for (int c = 0; c < dim; ++c) place[c] = std::bit_cast<int>(records[long(particle) * size + c]);
    const double* const unit = units.unit;
    for (int t = 0; t < n; t += L::count)
    {
        const float* record[L::count];
        for (int k = 0; k < L::count; ++k) record[k] = records + long(list[t + k]) * size;
        const auto first = loadFourColumns<L>([&](int k) { return record[k]; });
        for (int c = 0; c < dim; ++c) L::store(&to.x[c][t], (place[c] - L::asDoubles(std::bit_cast<Ints>(first.column[c]))) * unit[c]);
        for (int c = dim; c < 4; ++c) L::store(&to.field[c - dim][t], L::widened(first.column[c]) * unit[c]);
        for (int c = 4; c < dim + columnCount; c += 4)
        {
            const auto next = loadFourColumns<L>([&](int k) { return record[k] + c; });
            for (int k = 0; k < 4; ++k) L::store(&to.field[c - dim + k][t], L::widened(next.column[k]) * unit[c + k]);
        }
    }
}

/// Packs `count` records of so many columns, `to[i]` from element i of each coordinate and column, of as many arrays as a record has numbers.
template<int dim, class L = WidestLanes>
inline void packSingleRecords(const double* const* from, int columnCount, const SingleUnits<dim>& units, std::size_t count, float* to)
{
    const int size = singleRecordSize<dim>(columnCount);
    const auto scaled = [&](int c, auto q) { return c < dim ? (q - units.centre[c]) * units.perUnit[c] : q * units.perUnit[c]; };
    std::size_t i = 0;
    for (; i + L::count <= count; i += L::count)
        for (int c = 0; c < size; c += 4)
        {
            const auto column = [&](int k)
            {
                const auto q = scaled(c + k, L::template load<typename L::Doubles>(from[c + k] + i));
                return c + k < dim ? std::bit_cast<typename L::Floats>(L::rounded(q)) : L::narrowed(q);
            };
            storeFourColumns<L>([&](int k) { return to + (i + k) * size + c; }, {{column(0), column(1), column(2), column(3)}});
        }
    for (; i < count; ++i)
        for (int c = 0; c < size; ++c)
        {
            const double q = scaled(c, from[c][i]);
            to[i * size + c] = c < dim ? std::bit_cast<float>(detail::rounded(q)) : float(q);
        }
}

/// A number with the digits of single precision, and the range of double.
inline double toSinglePrecision(double q)
{
    constexpr int lost = 53 - 24;
    const auto bits = std::bit_cast<std::uint64_t>(q);
    const auto half = (std::uint64_t(1) << (lost - 1)) - 1 + (bits >> lost & 1);
    return std::bit_cast<double>((bits + half) >> lost << lost);
}

}
