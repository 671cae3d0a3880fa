#include "RegularGrid.hpp"
#include <algorithm>
#include <cmath>

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

}
