#include "geometry/FacetTree.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <numbers>
#include <numeric>

namespace sph
{

namespace
{
constexpr int trianglesPerLeaf = 4;
}

NearestOnTriangle nearestOnTriangle(const Vector<3>& x, const Vector<3>& a, const Vector<3>& b, const Vector<3>& c)
{
    const auto ab = b - a, ac = c - a, ax = x - a;
    const double d1 = dot(ab, ax), d2 = dot(ac, ax);
    if (d1 <= 0 && d2 <= 0) return {a, TrianglePart::corner0};
    const auto bx = x - b;
    const double d3 = dot(ab, bx), d4 = dot(ac, bx);
    if (d3 >= 0 && d4 <= d3) return {b, TrianglePart::corner1};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0) return {a + d1 / (d1 - d3) * ab, TrianglePart::edge2};
    const auto cx = x - c;
    const double d5 = dot(ab, cx), d6 = dot(ac, cx);
    if (d6 >= 0 && d5 <= d6) return {c, TrianglePart::corner2};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0) return {a + d2 / (d2 - d6) * ac, TrianglePart::edge1};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0) return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), TrianglePart::edge0};
    const double sum = va + vb + vc;
    return {a + vb / sum * ab + vc / sum * ac, TrianglePart::face};
}

FacetTree::FacetTree(const std::vector<Vector<3>>& points, const std::vector<std::array<int, 3>>& triangles)
{
    std::vector<Box> boxes;
    std::vector<Vector<3>> middles;
    for (const auto& [a, b, c] : triangles)
    {
        Box box{points[std::size_t(a)], points[std::size_t(a)]};
        for (const int p : {b, c})
            for (const auto k : coordinates)
            {
                box.low.*k = std::min(box.low.*k, points[std::size_t(p)].*k);
                box.high.*k = std::max(box.high.*k, points[std::size_t(p)].*k);
            }
        boxes.push_back(box);
        middles.push_back(0.5 * (box.low + box.high));
    }
    order_.resize(triangles.size());
    std::iota(order_.begin(), order_.end(), 0);
    if (!triangles.empty()) build(boxes, middles, 0, int(triangles.size()));
}

int FacetTree::build(const std::vector<Box>& boxes, const std::vector<Vector<3>>& middles, int first, int last)
{
    Node node;
    node.box = {{Box::infinity, Box::infinity, Box::infinity}, {-Box::infinity, -Box::infinity, -Box::infinity}};
    node.first = first;
    node.last = last;
    for (int i = first; i < last; ++i)
        for (const auto c : coordinates)
        {
            const auto& box = boxes[std::size_t(order_[std::size_t(i)])];
            node.box.low.*c = std::min(node.box.low.*c, box.low.*c);
            node.box.high.*c = std::max(node.box.high.*c, box.high.*c);
        }
    const int index = int(nodes_.size());
    nodes_.push_back(node);
    if (last - first <= trianglesPerLeaf) return index;
    auto longest = coordinates[0];
    for (const auto c : coordinates)
        if (node.box.high.*c - node.box.low.*c > node.box.high.*longest - node.box.low.*longest) longest = c;
    const int half = (first + last) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                     [&](int a, int b)
                     {
                         const double p = middles[std::size_t(a)].*longest, q = middles[std::size_t(b)].*longest;
                         return p < q || (p == q && a < b);
                     });
    const int left = build(boxes, middles, first, half), right = build(boxes, middles, half, last);
    nodes_[std::size_t(index)].left = left;
    nodes_[std::size_t(index)].right = right;
    return index;
}

void FacetTree::annotate(std::span<const Vector<3>> normals, std::span<const int> patch, std::span<const char> creased, double slack)
{
    for (auto& node : nodes_)
    {
        Vector<3> sum;
        node.patch = patch[std::size_t(node.first)];
        node.creased = false;
        for (int t = node.first; t < node.last; ++t)
        {
            sum += normals[std::size_t(t)];
            if (patch[std::size_t(t)] != node.patch) node.patch = -1;
            node.creased = node.creased || creased[std::size_t(t)];
        }
        node.halfAngle = std::numbers::pi;
        node.cosine = -1;
        if (mag(sum) < 1e-3 * (node.last - node.first)) continue;
        node.axis = sum / mag(sum);
        double least = 1;
        for (int t = node.first; t < node.last; ++t) least = std::min(least, dot(node.axis, normals[std::size_t(t)]));
        node.cosine = std::clamp(least, -1.0, 1.0);
        node.halfAngle = std::acos(node.cosine);
        const double smooth = std::min(node.halfAngle + slack, std::numbers::pi);
        node.smoothCosine = std::cos(smooth);
        node.smoothSine = std::sin(smooth);
    }
}

}
