#include "neighbours/RankBoxes.hpp"
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

int RankBoxes::owner(const Vector<3>& x) const
{
    int owner = -1;
    visit(
        x, std::numeric_limits<double>::min(),
        [&](int rank)
        {
            if (holds(of(rank), x)) owner = rank;
        },
        0, 0, count_);
    return owner;
}

}
