/// Sums over the cells of a regular grid that lie in the fluid, at the cost of those near walls: a block of cells that no wall comes near is asked as one.
#pragma once
#include "geometry/Geometry.hpp"
#include "geometry/components.hpp"
#include "packing/CellRange.hpp"

namespace sph
{

namespace detail
{
template<class Value, class OfBlock, class OfCell>
Value overBlock(const Geometry& g, const RegularCells& cells, const CellRange& range, double beyond, const OfBlock& ofBlock,
                const OfCell& ofCell)
{
    Vector<3> size, middle = cells.low;
    int widest = 0;
    long count = 1;
    for (int k = 0; k < g.dimension; ++k)
    {
        const auto c = component(k);
        const long n = range.high[k] - range.low[k];
        size.*c = double(n) * cells.step.*c;
        middle.*c += (double(range.low[k]) + 0.5 * double(n)) * cells.step.*c;
        if (n > range.high[widest] - range.low[widest]) widest = k;
        count *= n;
    }
    if (count == 0) return {};
    const double near = 0.5 * mag(size) + beyond, d = g.distance(middle);
    if (d > near) return ofBlock(range);
    if (d < -near) return {};
    if (count == 1) return ofCell(range.low, middle);
    auto first = range, second = range;
    first.high[widest] = second.low[widest] = range.low[widest] + (range.high[widest] - range.low[widest]) / 2;
    Value a{}, b{};
#pragma omp task shared(a) if (count > 1000)
    a = overBlock<Value>(g, cells, first, beyond, ofBlock, ofCell);
    b = overBlock<Value>(g, cells, second, beyond, ofBlock, ofCell);
#pragma omp taskwait
    return a + b;
}
}

/// `ofBlock(range)` of blocks in the fluid, and `ofCell(cell, middle)` of single cells within half a diagonal and `beyond` [m] of a wall. The same on any
/// number of threads.
template<class Value, class OfBlock, class OfCell>
Value overFluid(const Geometry& g, const RegularCells& cells, const CellRange& range, double beyond, const OfBlock& ofBlock,
                const OfCell& ofCell)
{
    Value all{};
#pragma omp parallel
#pragma omp single
    all = detail::overBlock<Value>(g, cells, range, beyond, ofBlock, ofCell);
    return all;
}

}
