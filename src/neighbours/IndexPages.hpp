/// Indices of particles in two bytes each: one of 16 pages, and a place in it.
///
/// What some hundred particles next to one another in memory see lies in a few stretches of the arrays, whatever the size of the scene: one for each
/// plane of cells, some more where there are images. A page may begin anywhere and holds 4096 particles. Lists of 2 bytes a neighbour in place of 4 are
/// what most of a scene's memory was; unpacking takes a few instructions a vector, and keeps the order. Differences from one index to the next would
/// take escapes and a sum along the list; a bit a candidate of the cells around was smaller still, and slow (test/benchmark/README.md).
#pragma once
#include "neighbours/lanes.hpp"
#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace sph
{

using IndexPages = std::array<int, detail::pageCount>; ///< where each begins

/// n indices from their codes. Reads and writes in eights: `codes` and `to` need room for 7 more.
template<class L = WidestLanes> inline void unpackIndices(const std::uint16_t* codes, int n, const IndexPages& pages, int* to)
{
    for (int t = 0; t < n; t += 8) L::unpack(codes + t, pages.data(), to + t);
}

/// Chooses the pages of indices. Keeps its memory from one set of indices to the next.
class IndexPacker
{
    static constexpr int grainBits = 10; ///< pages begin at multiples of 1024: a page holds any stretch of 3072
    static constexpr int untouched = std::numeric_limits<int>::max();
    std::vector<int> toCode_; ///< by grain: what makes a code of an index in it when added
    std::vector<int> touched_;

public:
    /// Writes the codes of indices from [0, total]. False, and codes without meaning, where they take more pages than there are.
    bool pack(std::span<const int> indices, std::size_t total, IndexPages& pages, std::uint16_t* codes)
    {
        if (total < std::size_t(detail::pageCount) * detail::pageSize)
        {
            for (int k = 0; k < detail::pageCount; ++k) pages[std::size_t(k)] = k * detail::pageSize;
            std::copy(indices.begin(), indices.end(), codes);
            return true;
        }
        const auto grains = (total >> grainBits) + 1;
        if (toCode_.size() < grains) toCode_.resize(grains, untouched);
        for (const int j : indices)
            if (int& code = toCode_[std::size_t(j) >> grainBits]; code == untouched)
            {
                code = 0;
                touched_.push_back(j >> grainBits);
            }
        std::sort(touched_.begin(), touched_.end());
        pages.fill(0);
        int n = 0;
        bool fits = true;
        for (const int grain : touched_)
        {
            const int first = grain << grainBits;
            if (n == 0 || first >= pages[std::size_t(n - 1)] + detail::pageSize)
            {
                fits = n < detail::pageCount;
                if (!fits) break;
                pages[std::size_t(n++)] = first;
            }
            toCode_[std::size_t(grain)] = ((n - 1) << detail::pageBits) - pages[std::size_t(n - 1)];
        }
        if (fits)
        {
            const int* const toCode = toCode_.data();
            const int* const from = indices.data();
#pragma GCC ivdep
            for (std::size_t t = 0; t < indices.size(); ++t) codes[t] = std::uint16_t(from[t] + toCode[from[t] >> grainBits]);
        }
        for (const int grain : touched_) toCode_[std::size_t(grain)] = untouched;
        touched_.clear();
        return fits;
    }
};

}
