/// The signed distance to the nearest of many patches, by a tree over their bounds: for sampling a scene at points that may be
/// far from every wall, where PatchGrid lists nothing.
#pragma once
#include "Shape.hpp"
#include <vector>

namespace sph
{

struct Patch;

class PatchTree
{
    struct Node
    {
        Box bounds;
        int first, last; ///< of order_, for a leaf
        int left = -1, right = -1;
    };
    std::vector<std::shared_ptr<const Shape>> bodies_; ///< whose solid lies within their bounds
    std::vector<std::shared_ptr<const Shape>> others_;
    std::vector<int> order_;
    std::vector<Node> nodes_;

    int build(const std::vector<Box>&, int first, int last);
    void visit(int node, const Vector<3>& x, double& best) const;

public:
    explicit PatchTree(const std::vector<Patch>&);

    /// The smaller of `best` and the smallest signed distance of x to a patch.
    double distance(const Vector<3>& x, double best = Box::infinity) const;
};

}
