#include "packing/Lattice.hpp"
#include "base/noise.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <cassert>
#include <cmath>

namespace sph
{

namespace
{
struct Pattern
{
    Vector<3> layerSpacing; ///< for a spacing of 1
    int period;             ///< layers a cell, 1 or 2
    bool (*occupied)(long i, long j, long k);
};

Pattern pattern(const std::string& type)
{
    const double root3 = std::sqrt(3.0);
    if (type == "hexagonal")
    {
        // a^2 sqrt(3)/2 = 1; columns a/2 apart, rows a sqrt(3)/2
        const double a = std::sqrt(2 / root3);
        return {{a / 2, a * root3 / 2, 1}, 2, [](long i, long j, long) { return (i + j) % 2 == 0; }};
    }
    if (type == "fcc")
    {
        const double half = std::cbrt(4.0) / 2;
        return {{half, half, half}, 2, [](long i, long j, long k) { return (i + j + k) % 2 == 0; }};
    }
    if (type == "bcc")
    {
        const double half = std::cbrt(2.0) / 2;
        return {{half, half, half}, 2, [](long i, long j, long k) { return i % 2 == j % 2 && j % 2 == k % 2; }};
    }
    assert(type == "cubic");
    return {{1, 1, 1}, 1, [](long, long, long) { return true; }};
}

long layersIn(double length, double layerSpacing, int period, bool periodic)
{
    if (periodic) return period * std::lround(length / (period * layerSpacing));
    return std::lround(length / layerSpacing);
}

/// Even or odd numbers of low <= i < high.
long ofParity(int parity, long low, long high) { return (high + 1 - parity) / 2 - (low + 1 - parity) / 2; }

using Cell = std::array<long, 3>;

/// f(cell) for all cells in any of the ranges, once each, x fastest.
template<int axis, class F> void forEachCell(std::span<const CellRange> ranges, Cell& cell, const F& f)
{
    std::vector<long> ends;
    for (const auto& r : ranges) ends.insert(ends.end(), {r.low[axis], r.high[axis]});
    std::sort(ends.begin(), ends.end());
    std::vector<CellRange> here;
    for (std::size_t e = 1; e < ends.size(); ++e)
    {
        if (ends[e - 1] == ends[e]) continue;
        here.clear();
        for (const auto& r : ranges)
            if (r.low[axis] <= ends[e - 1] && ends[e] <= r.high[axis]) here.push_back(r);
        if (here.empty()) continue;
        for (cell[axis] = ends[e - 1]; cell[axis] < ends[e]; ++cell[axis])
            if constexpr (axis == 0) f(cell);
            else forEachCell<axis - 1>(here, cell, f);
    }
}
}

const std::vector<std::string>& latticeNames(int dimension)
{
    static const std::vector<std::string> plane{"cubic", "hexagonal"}, space{"cubic", "fcc", "bcc"};
    return dimension == 2 ? plane : space;
}

Lattice::Lattice(const LatticeSpec& spec, int dimension, const Box& box, const std::array<bool, 3>& periodic)
    : cells{box.low, {}}, spec_(spec), dimension_(dimension), periodic_(periodic), occupied_(pattern(spec.type).occupied)
{
    const Pattern p = pattern(spec.type);
    const Vector<3> length = box.high - box.low;
    for (int k = 0; k < dimension; ++k)
    {
        const auto c = component(k);
        layers[k] = layersIn(length.*c, spec.spacing * p.layerSpacing.*c, p.period, periodic[k]);
        cells.step.*c = length.*c / double(layers[k]);
        fittedSpacing.*c = cells.step.*c / p.layerSpacing.*c;
    }
    if (dimension == 2) cells.low.z = 0;
}

double Lattice::farthestOff() const { return spec_.jitter * mag(fittedSpacing); }

CellRange Lattice::cellsIn(const Box& box) const
{
    CellRange range = all();
    for (int k = 0; k < dimension_; ++k)
    {
        const auto c = component(k);
        const auto cellAt = [&](double x) { return std::clamp(std::floor((x - cells.low.*c) / cells.step.*c), -1.0, double(layers[k])); };
        range.low[k] = std::clamp(long(cellAt(box.low.*c - farthestOff())), 0L, layers[k]);
        range.high[k] = std::clamp(long(cellAt(box.high.*c + farthestOff())) + 1, range.low[k], layers[k]);
    }
    return range;
}

std::vector<CellRange> Lattice::grown(std::span<const CellRange> ranges, double by) const
{
    std::vector<CellRange> result(ranges.begin(), ranges.end());
    for (int k = 0; k < dimension_; ++k)
    {
        const long n = layers[k], more = long(std::ceil(by / cells.step.*component(k)));
        std::vector<CellRange> across;
        for (auto& r : result)
        {
            r.low[k] -= more;
            r.high[k] += more;
            for (const long shift : {-n, n})
            {
                auto copy = r;
                copy.low[k] = std::max(0L, r.low[k] + shift);
                copy.high[k] = std::min(n, r.high[k] + shift);
                if (periodic_[k] && copy.low[k] < copy.high[k]) across.push_back(copy);
            }
            r.low[k] = std::max(0L, r.low[k]);
            r.high[k] = std::min(n, r.high[k]);
        }
        result.insert(result.end(), across.begin(), across.end());
    }
    return result;
}

std::size_t Lattice::count(const CellRange& r) const
{
    long all = 0;
    for (int cell = 0; cell < 8; ++cell)
    {
        const std::array parity{cell & 1, cell >> 1 & 1, cell >> 2};
        long here = occupied_(parity[0], parity[1], parity[2]);
        for (std::size_t k = 0; k < 3; ++k) here *= ofParity(parity[k], r.low[k], r.high[k]);
        all += here;
    }
    return std::size_t(all);
}

/// Particles before that of the cell, x fastest.
std::size_t Lattice::numberOf(const Cell& cell) const
{
    const auto [nx, ny, nz] = layers;
    const auto [i, j, k] = cell;
    return count({{0, 0, 0}, {nx, ny, k}}) + count({{0, 0, k}, {nx, j, k + 1}}) + count({{0, j, k}, {i, j + 1, k + 1}});
}

bool Lattice::holds(const Cell& cell) const { return occupied_(cell[0], cell[1], cell[2]); }

Vector<3> Lattice::particle(const Cell& cell) const
{
    Vector<3> x = cells.low + Vector<3>{(double(cell[0]) + 0.5) * cells.step.x, (double(cell[1]) + 0.5) * cells.step.y,
                                        (double(cell[2]) + 0.5) * cells.step.z};
    if (!(spec_.jitter > 0)) return x;
    std::uint64_t counter = 3 * numberOf(cell);
    for (const auto c : coordinates) x.*c += fittedSpacing.*c * spec_.jitter * (2 * noise(spec_.seed, counter++) - 1);
    return x;
}

Points Lattice::points(std::span<const CellRange> ranges, std::span<const CellRange> without) const
{
    Points all;
    Cell cell{};
    forEachCell<2>(ranges, cell,
                   [&](const Cell& at)
                   {
                       const auto left = [&](const CellRange& r) { return r.contains(at); };
                       if (holds(at) && std::ranges::none_of(without, left)) all.add(particle(at));
                   });
    return all;
}

}
