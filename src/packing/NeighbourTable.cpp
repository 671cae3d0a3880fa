#include "NeighbourTable.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace sph
{

namespace
{
class CellGrid
{
    Vector<3> low_;
    double size_;
    std::array<long, 3> n_{1, 1, 1};

public:
    CellGrid(const Points& p, std::size_t n, double size) : size_(size)
    {
        Vector<3> high;
        const auto span = [&](const std::vector<double>& x, double& low, double& top, long& cells)
        {
            const auto [a, b] = std::minmax_element(x.begin(), x.begin() + n);
            low = n ? *a : 0;
            top = n ? *b : 0;
            cells = long((top - low)/size_) + 1;
        };
        span(p.x, low_.x, high.x, n_[0]);
        span(p.y, low_.y, high.y, n_[1]);
        span(p.z, low_.z, high.z, n_[2]);
    }
    long cells() const { return n_[0]*n_[1]*n_[2]; }
    std::array<long, 3> at(const Vector<3>& x) const
    {
        return {long((x.x - low_.x)/size_), long((x.y - low_.y)/size_), long((x.z - low_.z)/size_)};
    }
    long cell(const std::array<long, 3>& c) const { return c[0] + n_[0]*(c[1] + n_[1]*c[2]); }
    long extent(int axis) const { return n_[axis]; }
};

/// Counting sort: the points of each cell, and where each cell begins.
std::vector<int> sortByCell(const CellGrid& grid, const Points& p, std::size_t n, std::vector<long>& begin)
{
    begin.assign(grid.cells() + 1, 0);
    std::vector<long> cell(n);
    for (std::size_t i = 0; i < n; ++i) ++begin[(cell[i] = grid.cell(grid.at(p[i]))) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<int> order(n);
    auto next = begin;
    for (std::size_t i = 0; i < n; ++i) order[next[cell[i]]++] = int(i);
    return order;
}
}

std::vector<int> cellOrder(const Points& points, std::size_t n, double size)
{
    std::vector<long> begin;
    return sortByCell(CellGrid(points, n, size), points, n, begin);
}

void NeighbourTable::build(const Points& points, std::size_t n, double reach)
{
    const std::size_t all = points.size();
    const CellGrid grid(points, all, reach);
    std::vector<long> begin;
    const auto order = sortByCell(grid, points, all, begin);
    Points sorted;
    sorted.resize(all);
    for (std::size_t k = 0; k < all; ++k) sorted.set(k, points[order[k]]);

    // Cells along x are consecutive in the sorted points: nine runs hold the 27 cells around a point.
    const auto visit = [&](std::size_t i, const auto& found)
    {
        const Vector<3> x = points[i];
        const auto [cx, cy, cz] = grid.at(x);
        const long x0 = std::max(cx - 1, 0L), x1 = std::min(cx + 1, grid.extent(0) - 1);
        for (long z = std::max(cz - 1, 0L); z <= std::min(cz + 1, grid.extent(2) - 1); ++z)
            for (long y = std::max(cy - 1, 0L); y <= std::min(cy + 1, grid.extent(1) - 1); ++y)
                for (long k = begin[grid.cell({x0, y, z})]; k < begin[grid.cell({x1, y, z}) + 1]; ++k)
                {
                    const double dx = x.x - sorted.x[k], dy = x.y - sorted.y[k], dz = x.z - sorted.z[k];
                    if (dx*dx + dy*dy + dz*dz < reach*reach && order[k] != int(i)) found(order[k]);
                }
    };

    start_.assign(n + 1, 0);
    const long points_ = long(n);
#pragma omp parallel for schedule(static)
    for (long i = 0; i < points_; ++i)
    {
        std::size_t count = 0;
        visit(i, [&](int) { ++count; });
        start_[i + 1] = count;
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    index_.resize(start_[n]);
#pragma omp parallel for schedule(static)
    for (long i = 0; i < points_; ++i)
    {
        int* next = index_.data() + start_[i];
        visit(i, [&](int j) { *next++ = j; });
    }
}

}
