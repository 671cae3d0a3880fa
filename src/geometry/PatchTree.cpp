#include "geometry/PatchTree.hpp"
#include "geometry/Geometry.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <numeric>

namespace sph
{

namespace
{

/// Twice the middle; 0 along directions without end.
double middle(const Box& b, double Vector<3>::*c) { return std::isfinite(b.low.*c) && std::isfinite(b.high.*c) ? b.low.*c + b.high.*c : 0; }

}

PatchTree::PatchTree(const std::vector<Patch>& patches)
{
    std::vector<Box> bounds;
    for (int p = 0; p < int(patches.size()); ++p)
    {
        const auto& shape = patches[std::size_t(p)].shape;
        (shape->enclosesFluid() ? others_ : bodies_).push_back({shape, p});
        if (!shape->enclosesFluid()) bounds.push_back(shape->bounds());
    }
    order_.resize(bodies_.size());
    std::iota(order_.begin(), order_.end(), 0);
    if (!bodies_.empty()) build(bounds, 0, int(bodies_.size()));
}

int PatchTree::build(const std::vector<Box>& bounds, int first, int last)
{
    Box all{{Box::infinity, Box::infinity, Box::infinity}, {-Box::infinity, -Box::infinity, -Box::infinity}};
    for (int i = first; i < last; ++i)
        for (const auto c : coordinates)
        {
            all.low.*c = std::min(all.low.*c, bounds[order_[i]].low.*c);
            all.high.*c = std::max(all.high.*c, bounds[order_[i]].high.*c);
        }
    const int index = int(nodes_.size());
    nodes_.push_back({all, first, last});
    if (last - first <= 4) return index;

    auto longest = coordinates[0];
    const auto extent = [&](double Vector<3>::*c) { return std::isfinite(all.high.*c - all.low.*c) ? all.high.*c - all.low.*c : 0; };
    for (const auto c : coordinates)
        if (extent(c) > extent(longest)) longest = c;
    const int half = (first + last) / 2;
    std::nth_element(order_.begin() + first, order_.begin() + half, order_.begin() + last,
                     [&](int a, int b) { return middle(bounds[a], longest) < middle(bounds[b], longest); });
    const int left = build(bounds, first, half), right = build(bounds, half, last);
    nodes_[index].left = left;
    nodes_[index].right = right;
    return index;
}

void PatchTree::consider(const Numbered& body, const Vector<3>& x, int except, NearestPatch& best)
{
    if (body.patch == except) return;
    // A point beside the bounds of a body lies in front of the body.
    const bool isBeside = !body.shape->enclosesFluid() && distanceTo(body.shape->bounds(), x) > 0;
    const double d = body.shape->distance(x, isBeside ? best.distance * (1 + 1e-12) : Box::infinity);
    if (d < best.distance || (d == best.distance && body.patch < best.patch)) best = {d, body.patch};
}

void PatchTree::visit(int index, const Vector<3>& x, int except, NearestPatch& best) const
{
    const auto& node = nodes_[index];
    if (node.left < 0)
    {
        for (int i = node.first; i < node.last; ++i) consider(bodies_[order_[i]], x, except, best);
        return;
    }
    // A body is at least as far as its bounds; within them it may be at any depth.
    const double toLeft = distanceTo(nodes_[node.left].bounds, x), toRight = distanceTo(nodes_[node.right].bounds, x);
    const bool leftFirst = toLeft <= toRight;
    for (const bool left : {leftFirst, !leftFirst})
        if (const double d = left ? toLeft : toRight; d <= best.distance || d == 0) visit(left ? node.left : node.right, x, except, best);
}

NearestPatch PatchTree::nearest(const Vector<3>& x, NearestPatch best, int except) const
{
    for (const auto& other : others_) consider(other, x, except, best);
    if (!nodes_.empty())
        if (const double d = distanceTo(nodes_.front().bounds, x); d <= best.distance || d == 0) visit(0, x, except, best);
    return best;
}

}
