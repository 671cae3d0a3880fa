#include "RankBoxes.hpp"
#include <algorithm>
#include <limits>

namespace sph
{

void RankBoxes::add(const std::vector<RankBox>& boxes, std::size_t node, int first, int last)
{
    if (nodes_.size() <= node) nodes_.resize(node + 1);
    if (last - first == 1)
    {
        nodes_[node] = boxes[std::size_t(first)];
        return;
    }
    const int half = (first + last) / 2;
    add(boxes, 2 * node + 1, first, half);
    add(boxes, 2 * node + 2, half, last);
    const auto &a = nodes_[2 * node + 1], &b = nodes_[2 * node + 2];
    for (std::size_t c = 0; c < 3; ++c)
    {
        nodes_[node].low[c] = std::min(a.low[c], b.low[c]);
        nodes_[node].high[c] = std::max(a.high[c], b.high[c]);
    }
}

std::size_t RankBoxes::leafOf(int rank) const
{
    std::size_t node = 0;
    for (int first = 0, last = count_; last - first > 1;)
    {
        const int half = (first + last) / 2;
        node = 2 * node + (rank < half ? 1 : 2);
        (rank < half ? last : first) = half;
    }
    return node;
}

double RankBoxes::squaredDistance(const RankBox& box, const Vector<3>& x)
{
    const double at[]{x.x, x.y, x.z};
    double squared = 0;
    for (std::size_t c = 0; c < 3; ++c)
    {
        const double beyond = std::max({0.0, box.low[c] - at[c], at[c] - box.high[c]});
        squared += beyond * beyond;
    }
    return squared;
}

double RankBoxes::squaredDistance(int rank, const Vector<3>& x) const { return squaredDistance(nodes_[leafOf(rank)], x); }

int RankBoxes::owner(const Vector<3>& x) const
{
    const double at[]{x.x, x.y, x.z};
    int owner = -1;
    visit(
        x, std::numeric_limits<double>::min(),
        [&](int rank)
        {
            const auto& box = nodes_[leafOf(rank)];
            bool within = true;
            for (std::size_t c = 0; c < 3; ++c) within = within && at[c] >= box.low[c] && at[c] < box.high[c];
            if (within) owner = rank;
        },
        0, 0, count_);
    return owner;
}

}
