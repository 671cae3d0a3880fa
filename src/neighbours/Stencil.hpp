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
template<int dim> struct Pair
{
    Vector<dim> x;
    double r, W, dWdrOverR;
    long j;
    Vector<dim> gradW = dWdrOverR * x;
};

template<int dim> struct Stencil
{
    static constexpr int lanes = NeighbourLists<dim>::lanes, capacity = NeighbourLists<dim>::mostNeighbours + 2 * lanes, maxColumns = 32;
    using Column = double[capacity];

    int i, n;                     ///< particle; entries, a multiple of the lanes
    alignas(64) long j[capacity]; ///< as wide as a double: gathers of whole vectors
    alignas(64) Column x[dim], r, W, dWdrOverR, field[maxColumns];
    int kept[capacity]; ///< of a list with a skin, those within the support

    /// Columns that travel in packed records with the positions.
    static constexpr int packedColumns = recordSize - dim;

    /// Packed arrays worth their memory for so many columns: the positions and the first columns, then full eights. What is left over is
    /// gathered by index: a two-phase bed by curvature, whose one such pass has five left over, was not measurably slower, and 65 bytes smaller.
    static constexpr int recordArrays(int columnCount) { return 1 + std::max(0, columnCount - packedColumns) / recordSize; }

    struct Factors
    {
        int weight = -1; ///< volume factors of images; -1 where every wall is plane
        int scale = -1;  ///< gradientScale N: gradW is divided by (N_i + N_j)/2; -1 where the pass has the raw gradient
    };

    /// `records`: positions and the first columns of all particles packed (records.hpp), then arrays of further columns, `recordArray`
    /// doubles apart. `within`: the list is one that an earlier pass has left (NeighbourLists::within). W and gradW are those of the kernel
    /// until `applyFactors`.
    template<class K>
    [[gnu::flatten]] void fill(int particle, std::span<const int> list, bool within, const std::array<const double*, dim>& position,
                               const double* records, std::size_t recordArray, std::span<const double* const> columns, const K kernel,
                               bool readsW, long nullParticle)
    {
        i = particle;
        Vector<dim> x_i;
        fetch(x_i, [&](int c) { return position[c][particle]; });
        const int packed = std::min(int(columns.size()), packedColumns);
        if (!within)
        {
            int found = selectRecords<dim>(records, list.data(), int(list.size()), x_i, sqr(kernel.H), kept);
            while (found % lanes) kept[found++] = int(nullParticle);
            list = {kept, std::size_t(found)};
        }
        n = int(list.size());
        fromRecords(records, list.data(), x_i, sqr(kernel.H), packed);

#pragma GCC ivdep
        for (int t = 0; t < n; ++t) dWdrOverR[t] = kernel.dWdrOverR(r[t]);
        if (readsW)
#pragma GCC ivdep
            for (int t = 0; t < n; ++t) W[t] = kernel.W(r[t]);

        std::size_t c = packed;
        for (int array = 1; array < recordArrays(int(columns.size())); ++array, c += recordSize)
            gatherColumns(records + array * recordArray, j, n, field + c);
        for (; c < columns.size(); ++c)
        {
            const double* const source = columns[c];
#pragma GCC ivdep
            for (int t = 0; t < n; ++t) field[c][t] = source[j[t]];
        }
    }

    /// `factors` names the columns of the factors that gradW carries.
    void applyFactors(const Factors factors, std::span<const double* const> columns, bool readsW)
    {
        const double* const weight = factors.weight >= 0 ? field[factors.weight] : nullptr;
        if (factors.scale >= 0)
        {
            const double* const N = field[factors.scale];
            const double N_i = columns[factors.scale][i];
            if (weight)
#pragma GCC ivdep
                for (int t = 0; t < n; ++t) dWdrOverR[t] *= 2 * weight[t] / (N_i + N[t]);
            else
#pragma GCC ivdep
                for (int t = 0; t < n; ++t) dWdrOverR[t] *= 2 / (N_i + N[t]);
        }
        else if (weight)
#pragma GCC ivdep
            for (int t = 0; t < n; ++t) dWdrOverR[t] *= weight[t];
        if (weight && readsW)
#pragma GCC ivdep
            for (int t = 0; t < n; ++t) W[t] *= weight[t];
    }

    void fromRecords(const double* records, const int* list, Vector<dim> x_i, double radiusSqr, int packed)
    {
        const auto gather = [&]<int count>(std::integral_constant<int, count>)
        { gatherRecords<dim, count>(records, list, n, x_i, radiusSqr, *this); };
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

    Pair<dim> pair(int t) const
    {
        Vector<dim> x_ij;
        fetch(x_ij, [&](int c) { return x[c][t]; });
        return {x_ij, r[t], W[t], dWdrOverR[t], j[t]};
    }
};

}
