/// Winding numbers of a surface around points: crossings of its facets by lines parallel to a coordinate.
#pragma once
#include "geometry/TriangleSurface.hpp"
#include "geometry/components.hpp"
#include <array>
#include <vector>

namespace sph
{

/// A line parallel to coordinate `axis`, at (u, v) of the two that follow it in cyclic order.
struct AxisLine
{
    double u, v;
};

struct Crossing
{
    int line, facet;
    int sign; ///< 1: upwards along the line it passes from the back of the facet to its front
};

struct Crossings
{
    std::vector<Crossing> all;
    std::vector<char> grazes; ///< lines that pass through an edge or a point: another one is to be taken
};
/// Exact: its predicates are.
Crossings crossingsOf(const TriangleSurface&, int axis, const std::vector<AxisLine>&);

/// Height along the axis of a facet on a line that crosses it, in numbers of type T.
template<class T> T heightOn(const TriangleSurface& s, int facet, int axis, const AxisLine& line)
{
    const auto coordinate = [&](std::size_t corner, int k)
    {
        const auto& x = s.points[std::size_t(s.triangles[std::size_t(facet)][corner])];
        return T(x.*component(k % 3));
    };
    const T u(line.u), v(line.v);
    const auto area = [&](std::size_t i, std::size_t j) // twice that of the triangle with corners i, j and the line
    {
        const T iu = coordinate(i, axis + 1) - u, iv = coordinate(i, axis + 2) - v;
        const T ju = coordinate(j, axis + 1) - u, jv = coordinate(j, axis + 2) - v;
        return T(iu * jv - iv * ju);
    };
    const T a = area(1, 2), b = area(2, 0), c = area(0, 1);
    return T((a * coordinate(0, axis) + b * coordinate(1, axis) + c * coordinate(2, axis)) / (a + b + c));
}

}
