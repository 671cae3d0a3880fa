/// The regular grid that surfaces are reconstructed on: it fills the domain, with nodes exactly on the domain's faces, or parts of a large one.
#pragma once
#include "geometry/Geometry.hpp"
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace sph
{

/// The grid: in a periodic direction the last node is the image of the first. In 2-D it is one layer of nodes in the plane z = 0.
struct RegularGrid
{
    int dimension = 3;
    Vector<3> low, step;
    std::array<int, 3> nodes{1, 1, 1};
    std::array<bool, 3> periodic{};

    std::size_t size() const { return std::size_t(nodes[0]) * nodes[1] * nodes[2]; }
    std::size_t index(int i, int j, int k) const { return i + std::size_t(nodes[0]) * (j + std::size_t(nodes[1]) * k); }
    Vector<3> node(int i, int j, int k) const { return {low.x + i * step.x, low.y + j * step.y, low.z + k * step.z}; }
    Vector<3> high() const { return node(nodes[0] - 1, nodes[1] - 1, nodes[2] - 1); }
    double smallestStep() const;
    double largestStep() const;
    /// Area (2-D) or volume (3-D) of a cell.
    double cellVolume() const { return dimension == 2 ? step.x * step.y : step.x * step.y * step.z; }

    /// Number i of direction `axis` brought back into the grid by periodicity; -1 where it lies outside.
    int wrapped(int axis, int i) const
    {
        const int last = nodes[axis] - 1;
        if (i >= 0 && i <= last) return i;
        if (!periodic[axis]) return -1;
        return (i % last + last) % last;
    }
};

/// Linear interpolation of values at the nodes in each direction; outside the grid the value at the nearest point of its faces.
double interpolated(const RegularGrid&, const std::vector<double>& values, const Vector<3>& x);

/// The grid of the domain of `geometry`, whose step in each direction is `spacing` or a little less, so that whole steps fit.
RegularGrid gridOfDomain(const Geometry& geometry, double spacing);

/// Parts of that grid, no two of which overlap, which reach `margin` [m] beyond each of the points: for a domain that is all but empty. Where a part comes
/// within `margin` of a periodic face it goes on from that face to the other.
std::vector<RegularGrid> gridsAround(const Geometry& geometry, double spacing, std::span<const Vector<3>> points, double margin);

/// Number of nodes that `gridOfDomain` would make; a double, since a mistaken spacing gives more than integers hold.
double nodesOfDomain(const Geometry& geometry, double spacing);

/// Signed distance to the walls at each node; empty without walls.
std::vector<double> wallDistances(const RegularGrid&, const Geometry&);

}
