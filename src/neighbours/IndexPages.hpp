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
    std::vector<char> isTouched_;        ///< by grain
    std::vector<int> touched_;           ///< grains that hold indices

    void touch(int j)
    {
        char& is = isTouched_[std::size_t(j) >> grainBits];
        if (!is) touched_.push_back(j >> grainBits);
        is = 1;
    }
    /// Pages that hold the touched grains, and how many, or -1 where they are too many.
    int choose(IndexPages& pages)
    {
        std::sort(touched_.begin(), touched_.end());
        pages.fill(0);
        int n = 0;
        for (const int grain : touched_)
        {
            const int first = grain << grainBits;
            if (n > 0 && first < pages[std::size_t(n - 1)] + detail::pageSize) continue;
            if (n == detail::pageCount) return -1;
            pages[std::size_t(n++)] = first;
        }
        return n;
    }
    /// The codes of indices in so many pages; false where one lies in none. Each index is compared with where the pages begin, a vector at once (test/benchmark/README.md).
    template<class L> static bool write(std::span<const int> indices, const IndexPages& pages, int pageCount, std::uint16_t* codes)
    {
        using Wide = FloatLanes<2 * L::count>;
        using Ints = typename Wide::Ints;
        Ints outside{};
        const auto block = [&](const int* from, std::uint16_t* to) __attribute__((always_inline))
        {
            const auto j = L::template load<Ints>(from);
            Ints first = pages[0] - Ints{}, code{};
            for (int p = 1; p < pageCount; ++p)
            {
                const Ints beyond = j >= pages[std::size_t(p)];
                first = beyond ? pages[std::size_t(p)] - Ints{} : first;
                code = beyond ? (p << detail::pageBits) - Ints{} : code;
            }
            outside |= (j - first) & ~(detail::pageSize - 1);
            typedef std::uint16_t Codes __attribute__((vector_size(2 * Wide::count)));
            L::store(to, __builtin_convertvector(code + (j - first), Codes));
        };
        std::size_t t = 0;
        for (; t + Wide::count <= indices.size(); t += Wide::count) block(indices.data() + t, codes + t);
        if (const std::size_t left = indices.size() - t; left > 0)
        {
            int last[Wide::count];
            std::uint16_t lastCodes[Wide::count];
            std::fill(std::copy_n(indices.data() + t, left, last), last + Wide::count, indices.back());
            block(last, lastCodes);
            std::copy_n(lastCodes, left, codes + t);
        }
        int any = 0;
        for (int k = 0; k < Wide::count; ++k) any |= outside[k];
        return any == 0;
    }

public:
    /// Writes the codes of indices from [0, total]. False, and codes without meaning, where they take more pages than there are. Lists of particles that lie in
    /// some order stay in few grains for many indices: some are looked at first, and all where one is found to lie in no page.
    template<class L = WidestLanes> bool pack(std::span<const int> indices, std::size_t total, IndexPages& pages, std::uint16_t* codes)
    {
        if (total < std::size_t(detail::pageCount) * detail::pageSize)
        {
            for (int k = 0; k < detail::pageCount; ++k) pages[std::size_t(k)] = k * detail::pageSize;
            std::copy(indices.begin(), indices.end(), codes);
            return true;
        }
        if (const auto grains = (total >> grainBits) + 1; isTouched_.size() < grains) isTouched_.resize(grains);
        bool packed = false;
        for (const std::size_t each : {4, 1})
        {
            for (std::size_t t = 0; t < indices.size(); t += each) touch(indices[t]);
            const int n = choose(pages);
            packed = n >= 0 && write<L>(indices, pages, n, codes);
            if (packed || n < 0) break;
        }
        for (const int grain : touched_) isTouched_[std::size_t(grain)] = 0;
        touched_.clear();
        return packed;
    }
};

}
