/// The nearest of many patches and the signed distance to it, by a tree over their bounds: for sampling a scene at points that may
/// be far from every wall, where PatchGrid lists nothing.
#pragma once
#include "geometry/Shape.hpp"
#include <vector>

namespace sph
{

struct Patch;

struct NearestPatch
{
    double distance = Box::infinity; ///< signed [m]
    int patch = -1;
};

class PatchTree
{
    struct Node
    {
        Box bounds;
        int first, last; ///< of order_, for a leaf
        int left = -1, right = -1;
    };
    struct Numbered
    {
        std::shared_ptr<const Shape> shape;
        int patch;
    };
    std::vector<Numbered> bodies_; ///< whose solid lies within their bounds
    std::vector<Numbered> others_;
    std::vector<int> order_;
    std::vector<Node> nodes_;

    int build(const std::vector<Box>&, int first, int last);
    static void consider(const Numbered&, const Vector<3>& x, int except, NearestPatch& best);
    void visit(int node, const Vector<3>& x, int except, NearestPatch& best) const;

public:
    explicit PatchTree(const std::vector<Patch>&);

    /// The nearer of `best` and the patch of the smallest signed distance from x, one left out: of several as near the first.
    NearestPatch nearest(const Vector<3>& x, NearestPatch best = {}, int except = -1) const;
};

}
