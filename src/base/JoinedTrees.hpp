/// Elements 0 to n - 1 in groups, which grow by joining two elements at a time. Each names another element of its group; the least one, the root, names itself.
#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

namespace sph
{

class JoinedTrees
{
    static constexpr int none = -1;
    std::vector<int> above_;

public:
    /// `n` elements, each alone; those for which isIn(i) is false never join.
    template<class F> void reset(std::size_t n, const F& isIn)
    {
        above_.resize(n);
        for (std::size_t i = 0; i < n; ++i) above_[i] = isIn(i) ? int(i) : none;
    }
    void reset(std::size_t n)
    {
        reset(n, [](std::size_t) { return true; });
    }

    bool isIn(std::size_t i) const { return above_[i] != none; }

    /// The least element of the group of i, which must be in.
    int rootOf(std::size_t i)
    {
        int root = int(i);
        while (above_[std::size_t(root)] != root) root = above_[std::size_t(root)] = above_[std::size_t(above_[std::size_t(root)])];
        return root;
    }

    void join(std::size_t a, std::size_t b)
    {
        if (!isIn(a) || !isIn(b)) return;
        const int one = rootOf(a), other = rootOf(b);
        above_[std::size_t(std::max(one, other))] = std::min(one, other);
    }
};

}
