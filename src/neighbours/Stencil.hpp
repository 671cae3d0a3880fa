/// The stencil of one particle: geometry and fields of its neighbours, computed once and held in the first-level cache.
///
///   x_ij = x_i - x_j [m],  r = |x_ij|,  W_ij [1/m^dim],  gradW_ij = (dW/dr) x_ij/r [1/m^(dim + 1)]   (gradient with respect to x_i)
///
/// Only here is the kernel known. Besides the geometry the block holds one column for each component that the terms of the pass read
/// at j, gathered once for all of them: a term's own loop has contiguous loads only. Blocks end on a multiple of 8 lanes with the
/// null particle (far away, W = 0): no loop has a scalar remainder.
#pragma once
#include "kernels/Kernel.hpp"
#include "neighbours/NeighbourLists.hpp"
#include "neighbours/records.hpp"
#include <algorithm>
#include <span>

namespace sph
{

/// One pair as a term sees it. Members that a term does not use cost nothing: they are made from the block in place.
template<int dim, class Real = double> struct Pair
{
    Vector<dim, Real> x;
    Real W, dWdrOverR;
    Real rr = dot(x, x); ///< r^2
    Vector<dim, Real> gradW = dWdrOverR * x;
    /// q, and 0 where the two are one particle.
    auto ofOther(Real q) const { return rr > 0 ? q : Real{}; }
};

/// What is known of the neighbours of a particle before its stencil is filled.
struct KnownNeighbours
{
    std::span<const int> list; ///< padded
    bool within = false;       ///< all of them lie within the support
    KeptSlopes slopes = {};    ///< (dW/dr)/r of the pairs, factors applied; none where they are to be computed
};

/// Columns of the factors that W and gradW of a pair carry.
struct PairFactors
{
    int weight = -1; ///< volume factors of images; -1 where every wall is plane, and where no factor is wanted
    int scale = -1;  ///< gradientScale N: gradW is divided by (N_i + N_j)/2; -1 where the pass has the raw gradient, or kept ones
};

/// The columns of a stencil, of numbers of that precision.
template<int dim, class Real> struct PairColumns
{
    static constexpr int lanes = NeighbourLists<dim>::lanes, capacity = NeighbourLists<dim>::mostNeighbours + 2 * lanes, maxColumns = 40;
    using Column = Real[capacity];

    int i, n;                                                       ///< particle; entries, a multiple of the lanes
    int listed;                                                     ///< of them, those that `j` names
    const int* j;                                                   ///< of each entry
    alignas(64) Column x[dim], W, dWdrOverR, field[maxColumns + 4]; ///< the last of records of single precision may be empty

    Pair<dim, Real> pair(int t) const
    {
        Vector<dim, Real> x_ij;
        fetch(x_ij, [&](int c) { return x[c][t]; });
        return {x_ij, W[t], dWdrOverR[t]};
    }

    /// gradW that was known has its own factors.
    void applyFactors(const PairFactors factors, std::span<const double* const> columns, bool readsW, bool knownGradW)
    {
        const Real* const weight = factors.weight >= 0 ? field[factors.weight] : nullptr;
        if (factors.scale >= 0)
        {
            const Real* const N = field[factors.scale];
            const Real N_i(columns[factors.scale][i]);
            if (weight)
#pragma GCC ivdep
                for (int t = 0; t < n; ++t) dWdrOverR[t] *= 2 * weight[t] / (N_i + N[t]);
            else
#pragma GCC ivdep
                for (int t = 0; t < n; ++t) dWdrOverR[t] *= 2 / (N_i + N[t]);
        }
        else if (weight && !knownGradW)
#pragma GCC ivdep
            for (int t = 0; t < n; ++t) dWdrOverR[t] *= weight[t];
        if (weight && readsW)
#pragma GCC ivdep
            for (int t = 0; t < n; ++t) W[t] *= weight[t];
    }
};

template<int dim, class Real = double> struct Stencil : PairColumns<dim, Real>
{
    using Columns = PairColumns<dim, Real>;
    using Columns::dWdrOverR, Columns::field, Columns::i, Columns::j, Columns::lanes, Columns::listed, Columns::n, Columns::W;
    alignas(64) typename Columns::Column r;
    int kept[Columns::capacity]; ///< of a list with a skin, those within the support

    /// Columns that travel in packed records with the positions.
    static constexpr int packedColumns = recordSize - dim;

    /// Doubles a particle in the packed array of that number: the positions and the first columns, then eights, then what is left over in pairs. A
    /// single last column is gathered by index. 0 where there is no such array.
    static constexpr int recordWidth(int array, int columnCount)
    {
        if (array == 0) return recordSize;
        const int left = columnCount - packedColumns - (array - 1) * recordSize;
        return left < 2 ? 0 : std::min(recordSize, (left + 1) / 2 * 2);
    }
    /// Whether the last column is gathered by index.
    static constexpr bool lastByIndex(int columnCount)
    {
        int packed = packedColumns;
        for (int array = 1; recordWidth(array, columnCount) > 0; ++array) packed += recordWidth(array, columnCount);
        return packed < columnCount;
    }
    /// Doubles a particle in all of them.
    static constexpr int recordsWidth(int columnCount)
    {
        int sum = 0;
        for (int array = 0; recordWidth(array, columnCount) > 0; ++array) sum += recordWidth(array, columnCount);
        return sum;
    }

    /// `records`: positions and the first columns of all particles packed (records.hpp), then arrays of further columns of so many `particles`. W and gradW
    /// are those of the kernel until `applyFactors`, unless gradW is known. r is computed for the kernel alone.
    template<class K>
    [[gnu::flatten]] void fill(int particle, const KnownNeighbours& known, const std::array<const double*, dim>& position,
                               const double* records, std::size_t particles, std::span<const double* const> columns, const K kernel,
                               bool readsW, long nullParticle)
    {
        i = particle;
        Vector<dim> x_i;
        fetch(x_i, [&](int c) { return position[c][particle]; });
        j = known.list.data();
        n = int(known.list.size());
        if (!known.within)
        {
            n = selectRecords<dim>(records, j, n, x_i, sqr(kernel.H), kept);
            while (n % lanes) kept[n++] = int(nullParticle);
            j = kept;
        }
        listed = n;
        const int count = int(columns.size()), packed = std::min(count, packedColumns);
        fromRecords(records, x_i, sqr(kernel.H), packed, readsW || !known.slopes);

        if (known.slopes) known.slopes.read(dWdrOverR, n);
        else
#pragma GCC ivdep
            for (int t = 0; t < n; ++t) dWdrOverR[t] = kernel.dWdrOverR(r[t]);
        if (readsW)
#pragma GCC ivdep
            for (int t = 0; t < n; ++t) W[t] = kernel.W(r[t]);

        int c = packed;
        const double* array = records;
        for (int a = 1; recordWidth(a, count) > 0; c += recordWidth(a, count), ++a)
        {
            array += recordWidth(a - 1, count) * particles;
            gatherColumns(array, recordWidth(a, count), j, n, field + c);
        }
        if (c < count)
#pragma GCC ivdep
            for (int t = 0; t < n; ++t) field[c][t] = columns[c][j[t]];
    }

private:
    void fromRecords(const double* records, Vector<dim> x_i, double radiusSqr, int packed, bool distances)
    {
        const auto gather = [&]<int count>(std::integral_constant<int, count>)
        {
            if (distances) gatherRecords<dim, count, true>(records, j, n, x_i, radiusSqr, *this);
            else gatherRecords<dim, count, false>(records, j, n, x_i, radiusSqr, *this);
        };
        switch (packed)
        {
        case 0:
            return gather(std::integral_constant<int, 0>{});
        case 1:
            return gather(std::integral_constant<int, 1>{});
        case 2:
            return gather(std::integral_constant<int, 2>{});
        case 3:
            return gather(std::integral_constant<int, 3>{});
        case 4:
            return gather(std::integral_constant<int, 4>{});
        default:
            return gather(std::integral_constant<int, packedColumns>{});
        }
    }
};

/// A stencil of single precision, in as many lanes as a vector has floats: positions and all columns come from one array of records.
template<int dim> struct Stencil<dim, Single> : PairColumns<dim, Single>
{
    using Columns = PairColumns<dim, Single>;
    using Columns::dWdrOverR, Columns::i, Columns::j, Columns::lanes, Columns::listed, Columns::n, Columns::W, Columns::x;
    alignas(64) typename Columns::Column r;
    int kept[Columns::capacity];

    /// Null particles lie beyond any support (PlaceUnits), so that the kernel of theirs is 0 without a mask.
    template<class K>
    void fill(int particle, const KnownNeighbours& known, const float* records, int columnCount, const PlaceUnits<dim>& units,
              const K kernel, bool readsW, long nullParticle)
    {
        i = particle;
        j = known.list.data();
        listed = int(known.list.size());
        if (!known.within)
        {
            listed = selectSingleRecords<dim>(records, columnCount, units, i, j, listed, kernel.H, kept);
            while (listed % lanes) kept[listed++] = int(nullParticle);
            j = kept;
        }
        n = gatherSingleRecords<dim>(records, columnCount, units, i, j, listed, *this);
        if (readsW || !known.slopes)
#pragma GCC ivdep
            for (int t = 0; t < n; ++t) r[t] = sqrt(this->pair(t).rr);
        if (known.slopes) known.slopes.read(&dWdrOverR[0].value, listed);
        else
#pragma GCC ivdep
            for (int t = 0; t < n; ++t) dWdrOverR[t] = kernel.dWdrOverR(r[t]);
        std::fill(dWdrOverR + listed, dWdrOverR + n, Single{});
        if (!readsW) return;
#pragma GCC ivdep
        for (int t = 0; t < n; ++t) W[t] = kernel.W(r[t]);
        std::fill(W + listed, W + n, Single{});
    }
};

}
