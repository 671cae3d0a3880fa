/// Which of n elements are joined to one another, by joining two at a time: each names another of its own, and the least of them itself, the root.
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
    /// `n` elements, each alone; those for which isIn(i) is false are joined to none.
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

    /// The least element of those that i, which is in, is joined to.
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
