/// Full neighbour lists of the owned particles, each padded with the null particle to a multiple of the vector lanes.
///
/// A list holds the particle itself: sums that include j = i need no extra line, and every difference vanishes. `radius` is the
/// kernel's support plus a skin.
#pragma once
#include "CellList.hpp"
#include <span>
#include <vector>

namespace sph
{

template<int dim> class NeighbourLists
{
public:
    static constexpr int lanes = 8;
    /// More neighbours than this mean particles on top of one another, and end in an error.
    static constexpr int mostNeighbours = 1024;

    /// Lists the first `owned` of the particles 0 .. total - 1; index `total` is the null particle. Throws CaseError, with the position,
    /// where a particle has more than mostNeighbours.
    void build(const std::array<const double*, dim>& x, std::size_t owned, std::size_t total, double radius);

    /// Of each place, that of the null particle included, whether a list names it.
    std::vector<char> seen() const;
    /// Particles have gone to other places, place[j] that of j, which must rise as j does; the last is that of the null particle.
    void renumber(std::span<const int> place);

    std::span<const int> of(std::size_t i) const
    {
        const Chunk& c = chunks_[i / chunkSize];
        return {c.entries.data() + c.begin[i % chunkSize], c.entries.data() + c.begin[i % chunkSize + 1]};
    }
    /// What a pass found within the support, kept for the passes behind it: they need not look at the skin again. `makeRoom` once before a
    /// loop of `keep`s; j holds a multiple of the lanes.
    void makeRoomWithin();
    void keepWithin(std::size_t i, const long* j, int n)
    {
        Chunk& c = chunks_[i / chunkSize];
        int* const to = c.within.data() + c.begin[i % chunkSize];
#pragma GCC ivdep
        for (int t = 0; t < n; ++t) to[t] = int(j[t]);
        c.withinCount[i % chunkSize] = n;
    }
    std::span<const int> within(std::size_t i) const
    {
        const Chunk& c = chunks_[i / chunkSize];
        return {c.within.data() + c.begin[i % chunkSize], std::size_t(c.withinCount[i % chunkSize])};
    }
    /// Parts the owned particles into those whose neighbours are all owned, and the others, both ascending: what ranks can compute before they have heard
    /// of one another, and what not. Anew after each build.
    void partInterior();
    std::span<const int> interior() const { return interior_; }
    std::span<const int> border() const { return border_; }
    /// Without padding, self included.
    std::size_t pairs() const { return pairs_; }
    std::size_t bytes() const;

private:
    /// Particles listed by one thread at a time into a buffer of their own.
    static constexpr std::size_t chunkSize = 1024;
    struct Chunk
    {
        std::vector<int> entries;
        std::array<unsigned, chunkSize + 1> begin;
        std::vector<int> within, withinCount; ///< at the places of `entries`, none where no pass keeps
        std::size_t pairs;
    };
    std::vector<Chunk> chunks_;
    CellList<dim> cells_;
    std::vector<int> interior_, border_;
    std::size_t owned_ = 0;
    int nullParticle_ = 0;
    std::size_t pairs_ = 0;
};

}
