#include "surfaces/RegularGrid.hpp"
#include <algorithm>
#include <cmath>
#include <map>

namespace sph
{

namespace
{

/// Steps of at most `spacing` that a length is divided into; the margin keeps 1e-3/0.25e-4 at 40 in spite of round-off.
double stepsIn(double length, double spacing) { return std::max(2.0, std::ceil(length / spacing - 1e-6)); }

std::array<double, 3> extent(const Geometry& g) { return {g.high.x - g.low.x, g.high.y - g.low.y, g.high.z - g.low.z}; }

}

double RegularGrid::smallestStep() const
{
    const double inPlane = std::min(step.x, step.y);
    return dimension == 2 ? inPlane : std::min(inPlane, step.z);
}

double RegularGrid::largestStep() const
{
    const double inPlane = std::max(step.x, step.y);
    return dimension == 2 ? inPlane : std::max(inPlane, step.z);
}

RegularGrid gridOfDomain(const Geometry& geometry, double spacing)
{
    const auto length = extent(geometry);
    RegularGrid grid;
    grid.dimension = geometry.dimension;
    grid.low = geometry.low;
    std::array<double, 3> step{};
    for (int d = 0; d < geometry.dimension; ++d)
    {
        const double steps = stepsIn(length[d], spacing);
        step[d] = length[d] / steps;
        grid.nodes[d] = int(steps) + 1;
        grid.periodic[d] = geometry.periodic[d];
    }
    if (geometry.dimension == 2) grid.low.z = 0;
    grid.step = {step[0], step[1], step[2]};
    return grid;
}

namespace
{
using Nodes = std::array<int, 3>;

/// Nodes from low to high of the domain's grid, both included.
struct NodeBox
{
    Nodes low, high;
};

bool overlap(const NodeBox& a, const NodeBox& b)
{
    for (std::size_t d = 0; d < 3; ++d)
        if (a.low[d] > b.high[d] || b.low[d] > a.high[d]) return false;
    return true;
}

NodeBox boxAround(const NodeBox& a, const NodeBox& b)
{
    NodeBox both = a;
    for (std::size_t d = 0; d < 3; ++d)
    {
        both.low[d] = std::min(a.low[d], b.low[d]);
        both.high[d] = std::max(a.high[d], b.high[d]);
    }
    return both;
}

/// Boxes that overlap become one, until none do.
std::vector<NodeBox> apart(std::vector<NodeBox> boxes)
{
    std::vector<NodeBox> result;
    while (!boxes.empty())
    {
        auto box = boxes.back();
        boxes.pop_back();
        const auto other = std::ranges::find_if(result, [&](const NodeBox& r) { return overlap(box, r); });
        if (other == result.end())
        {
            result.push_back(box);
            continue;
        }
        boxes.push_back(boxAround(box, *other));
        result.erase(other);
    }
    return result;
}
}

std::vector<RegularGrid> gridsAround(const Geometry& geometry, double spacing, std::span<const Vector<3>> points, double margin)
{
    const auto domain = gridOfDomain(geometry, spacing);
    const std::array low{domain.low.x, domain.low.y, domain.low.z}, step{domain.step.x, domain.step.y, domain.step.z};
    const auto boxOf = [&](const Vector<3>& point)
    {
        const std::array x{point.x, point.y, point.z};
        NodeBox box{{0, 0, 0}, {0, 0, 0}};
        for (int d = 0; d < domain.dimension; ++d)
        {
            const int last = domain.nodes[d] - 1;
            const double from = std::floor((x[d] - margin - low[d]) / step[d]), to = std::ceil((x[d] + margin - low[d]) / step[d]);
            const bool whole = domain.periodic[d] && (from <= 0 || to >= last);
            box.low[d] = whole ? 0 : int(std::clamp(from, 0.0, double(last)));
            box.high[d] = whole ? last : int(std::clamp(to, 0.0, double(last)));
        }
        return box;
    };
    // Points in one block of cells as wide as the margin are one box, of which there are then few.
    std::map<Nodes, NodeBox> ofBlocks;
    for (const auto& x : points)
    {
        const auto box = boxOf(x);
        Nodes block{};
        for (int d = 0; d < domain.dimension; ++d) block[d] = box.low[d] / std::max(1, int(margin / step[d]));
        const auto [at, isNew] = ofBlocks.try_emplace(block, box);
        if (!isNew) at->second = boxAround(at->second, box);
    }
    std::vector<NodeBox> boxes;
    for (const auto& [block, box] : ofBlocks) boxes.push_back(box);
    std::vector<RegularGrid> grids;
    for (const auto& box : apart(std::move(boxes)))
    {
        auto grid = domain;
        grid.low = domain.node(box.low[0], box.low[1], box.low[2]);
        for (int d = 0; d < domain.dimension; ++d)
        {
            grid.nodes[d] = box.high[d] - box.low[d] + 1;
            grid.periodic[d] = domain.periodic[d] && grid.nodes[d] == domain.nodes[d];
        }
        grids.push_back(grid);
    }
    return grids;
}

double nodesOfDomain(const Geometry& geometry, double spacing)
{
    const auto length = extent(geometry);
    double nodes = 1;
    for (int d = 0; d < geometry.dimension; ++d) nodes *= stepsIn(length[d], spacing) + 1;
    return nodes;
}

std::vector<double> wallDistances(const RegularGrid& grid, const Geometry& geometry)
{
    if (geometry.patches.empty()) return {};
    std::vector<double> distance(grid.size());
    const int rows = grid.nodes[1] * grid.nodes[2];
#pragma omp parallel for schedule(dynamic, 16)
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < grid.nodes[0]; ++i)
        {
            const int j = row % grid.nodes[1], k = row / grid.nodes[1];
            distance[grid.index(i, j, k)] = geometry.distance(grid.node(i, j, k));
        }
    return distance;
}

double interpolated(const RegularGrid& grid, const std::vector<double>& values, const Vector<3>& x)
{
    const std::array<double, 3> at{x.x - grid.low.x, x.y - grid.low.y, x.z - grid.low.z}, step{grid.step.x, grid.step.y, grid.step.z};
    std::array<int, 3> first{};
    std::array<double, 3> share{};
    for (int d = 0; d < grid.dimension; ++d)
    {
        const double steps = std::clamp(at[d] / step[d], 0.0, double(grid.nodes[d] - 1));
        first[d] = std::min(int(steps), grid.nodes[d] - 2);
        share[d] = steps - first[d];
    }
    double sum = 0;
    for (int corner = 0; corner < (1 << grid.dimension); ++corner)
    {
        double weight = 1;
        std::array<int, 3> node = first;
        for (int d = 0; d < grid.dimension; ++d)
        {
            const bool far = corner >> d & 1;
            node[d] += far;
            weight *= far ? share[d] : 1 - share[d];
        }
        sum += weight * values[grid.index(node[0], node[1], node[2])];
    }
    return sum;
}

}
