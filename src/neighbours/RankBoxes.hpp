/// The boxes of all ranks, which fill space, in a tree over their numbers: cuts that halve space number both halves through, so that what is near a place is
/// found in the depth of the tree.
#pragma once
#include "base/Vector.hpp"
#include "parallel/Ranks.hpp"
#include <algorithm>
#include <vector>

namespace sph
{

class RankBoxes
{
    int count_ = 0;
    std::vector<RankBox> nodes_; ///< bounds of the boxes first .. last - 1, those of both halves in 2 k + 1 and 2 k + 2; of a leaf its box

public:
    RankBoxes() = default;
    explicit RankBoxes(const std::vector<RankBox>& boxes) : count_(int(boxes.size())) { add(boxes, 0, 0, count_); }

    int count() const { return count_; }
    /// f(rank) of each whose box lies within `reach` [m] of x.
    template<class F> void forEachNear(const Vector<3>& x, double reach, const F& f) const { visit(x, reach * reach, f, 0, 0, count_); }
    const RankBox& of(int rank) const { return nodes_[leafOf(rank)]; }
    /// Rank in whose box x lies, lower faces included; -1 where x is NaN.
    int owner(const Vector<3>& x) const;

    /// Zero within the box.
    static double squaredDistance(const RankBox& box, const Vector<3>& x)
    {
        double squared = 0;
        forEachSide(box, x, [&](double aboveLow, double belowHigh) { squared += sqr(std::max({0.0, -aboveLow, -belowHigh})); });
        return squared;
    }
    /// Lower faces included.
    static bool holds(const RankBox& box, const Vector<3>& x)
    {
        bool within = true;
        forEachSide(box, x, [&](double aboveLow, double belowHigh) { within = within && aboveLow >= 0 && belowHigh > 0; });
        return within;
    }
    /// Whether all that is nearer to x than `reach` [m] lies in the box.
    static bool holdsAround(const RankBox& box, const Vector<3>& x, double reach)
    {
        bool within = true;
        forEachSide(box, x, [&](double aboveLow, double belowHigh) { within = within && aboveLow >= reach && belowHigh >= reach; });
        return within;
    }

private:
    template<class F> static void forEachSide(const RankBox& box, const Vector<3>& x, const F& f)
    {
        f(x.x - box.low[0], box.high[0] - x.x);
        f(x.y - box.low[1], box.high[1] - x.y);
        f(x.z - box.low[2], box.high[2] - x.z);
    }
    void add(const std::vector<RankBox>&, std::size_t node, int first, int last);
    std::size_t leafOf(int rank) const;
    template<class F> void visit(const Vector<3>& x, double squaredReach, const F& f, std::size_t node, int first, int last) const
    {
        if (first == last || !(squaredDistance(nodes_[node], x) < squaredReach)) return;
        if (last - first == 1) return f(first);
        const int half = (first + last) / 2;
        visit(x, squaredReach, f, 2 * node + 1, first, half);
        visit(x, squaredReach, f, 2 * node + 2, half, last);
    }
};

}
