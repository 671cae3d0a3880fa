/// Triangles in a tree of boxes, and the nearest point of a triangle.
///
/// A node knows, besides its box, the cone of its triangles' normals and whether they all belong to one smooth patch: searches for mirror images and
/// for what competes with them leave out whole branches by these.
#pragma once
#include "geometry/Shape.hpp"
#include <array>
#include <cmath>
#include <span>
#include <vector>

namespace sph
{

/// Part of a triangle on which its nearest point lies.
enum class TrianglePart : unsigned char
{
    face,
    edge0, ///< opposite corner 0
    edge1,
    edge2,
    corner0,
    corner1,
    corner2
};

struct NearestOnTriangle
{
    Vector<3> point;
    TrianglePart part = TrianglePart::face;
};

/// Ericson, Real-Time Collision Detection (2005), section 5.1.5: by the regions of the triangle's plane.
NearestOnTriangle nearestOnTriangle(const Vector<3>& x, const Vector<3>& a, const Vector<3>& b, const Vector<3>& c);

class FacetTree
{
public:
    struct Node
    {
        Box box;
        Vector<3> axis;           ///< of the cone of normals
        double halfAngle = 0;     ///< [rad]; pi where normals point everywhere
        double cosine = 1;        ///< of halfAngle
        double smoothCosine = -1; ///< of the cone of the smooth surface's normals: halfAngle and by how much triangles' may be off
        double smoothSine = 0;
        int patch = -1;          ///< of all triangles below; -1 where they differ
        bool creased = false;    ///< some triangle below has an edge that is no smooth one
        int first = 0, last = 0; ///< positions in order()
        int left = -1, right = -1;
        bool isLeaf() const { return left < 0; }
        /// cos of the largest angle between a triangle's normal and n; -1 at least.
        double mostTurned(const Vector<3>& n) const
        {
            const double c = dot(axis, n);
            return c <= -cosine ? -1 : c * cosine - std::sqrt(std::max((1 - c * c) * (1 - cosine * cosine), 0.0));
        }
        /// Whether x may lie on a normal of the smooth surface that triangles below stand for, no further than `behind` it.
        bool mayHaveNormalThrough(const Vector<3>& x, double behind) const
        {
            if (smoothCosine <= 0) return true;
            const auto way = x - 0.5 * (box.low + box.high);
            const double along = dot(way, axis), aside2 = dot(way, way) - along * along, radius = 0.5 * mag(box.high - box.low);
            const double widest = radius + (mag(way) + radius) * smoothSine;
            return along >= -(radius + behind) && aside2 < 1.001 * widest * widest;
        }
    };

    FacetTree() = default;
    FacetTree(const std::vector<Vector<3>>& points, const std::vector<std::array<int, 3>>& triangles);

    /// Triangles in the order of the leaves.
    const std::vector<int>& order() const { return order_; }
    const std::vector<Node>& nodes() const { return nodes_; }
    /// Fills in cones, patches and creases, of triangles in the order of the leaves, whose normals may be off by `slack` [rad].
    void annotate(std::span<const Vector<3>> normals, std::span<const int> patch, std::span<const char> creased, double slack);

    /// Calls leaf(position) for each triangle of each leaf that is reached; branches whose node `enter` refuses are left out.
    template<class Enter, class Leaf> void visit(const Enter& enter, const Leaf& leaf) const
    {
        if (nodes_.empty()) return;
        int stack[64], depth = 0;
        stack[depth++] = 0;
        while (depth > 0)
        {
            const Node& node = nodes_[std::size_t(stack[--depth])];
            if (!enter(node)) continue;
            if (node.isLeaf())
                for (int t = node.first; t < node.last; ++t) leaf(t);
            else
            {
                stack[depth++] = node.right;
                stack[depth++] = node.left;
            }
        }
    }

    /// Smallest `distance(position)` below `best`, and which triangle's; -1 where none is. Branches whose box is further than the best so far, or
    /// that skip(node, distance to its box) names, are left out; the nearer half comes first. Of nodes with a diagonal up to `grain` one triangle stands
    /// for all.
    template<class Distance, class Skip>
    std::pair<double, int> nearest(const Vector<3>& x, double best, double grain, const Distance& distance, const Skip& skip) const
    {
        int found = -1;
        struct Waiting
        {
            int node;
            double distance;
        };
        Waiting stack[64];
        int depth = 0;
        if (!nodes_.empty()) stack[depth++] = {0, distanceTo(nodes_[0].box, x)};
        while (depth > 0)
        {
            const auto [index, toBox] = stack[--depth];
            if (toBox > best) continue;
            const Node& node = nodes_[std::size_t(index)];
            if (skip(node, toBox)) continue;
            const auto size = node.box.high - node.box.low;
            const bool isGrain = dot(size, size) <= grain * grain;
            if (isGrain || node.isLeaf())
            {
                const int middle = (node.first + node.last) / 2;
                for (int t = isGrain ? middle : node.first; t < (isGrain ? middle + 1 : node.last); ++t)
                    if (const double d = distance(t); d < best || (d == best && t < found))
                    {
                        best = d;
                        found = t;
                    }
                continue;
            }
            const double toLeft = distanceTo(nodes_[std::size_t(node.left)].box, x),
                         toRight = distanceTo(nodes_[std::size_t(node.right)].box, x);
            const bool leftFirst = toLeft <= toRight;
            stack[depth++] = leftFirst ? Waiting{node.right, toRight} : Waiting{node.left, toLeft};
            stack[depth++] = leftFirst ? Waiting{node.left, toLeft} : Waiting{node.right, toRight};
        }
        return {best, found};
    }

private:
    std::vector<int> order_;
    std::vector<Node> nodes_;
    int build(const std::vector<Box>&, const std::vector<Vector<3>>& middles, int first, int last);
};

}
