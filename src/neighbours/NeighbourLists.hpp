/// Full neighbour lists of the owned particles, each padded with the null particle to a multiple of the vector lanes.
///
/// In memory they are codes of two bytes (IndexPages.hpp) without padding, or nothing at all, where each is to be read once or twice only: then they are
/// found anew in the cells for who asks.
///
/// A list holds the particle itself: sums that include j = i need no extra line, and every difference vanishes. `radius` is the
/// kernel's support plus a skin; a list may hold what lies farther by 2^-28 of the scene's extent and a millionth of the radius (select.hpp).
#pragma once
#include "neighbours/CellList.hpp"
#include "neighbours/IndexPages.hpp"
#include "neighbours/select.hpp"
#include <algorithm>
#include <span>
#include <vector>

namespace sph
{

/// (dW/dr)/r of the pairs of one particle as they are kept, in one of the two precisions.
struct KeptSlopes
{
    double* exact = nullptr;
    float* single = nullptr;

    explicit operator bool() const { return exact || single; }
    void keep(const auto* from, int n) const
    {
        if (single) std::transform(from, from + n, single, [](auto q) { return float(q); });
        else std::transform(from, from + n, exact, [](auto q) { return double(q); });
    }
    /// n is a multiple of 8: copied by as many, since a call of memmove takes longer than what it copies here.
    void read(auto* to, int n) const
    {
        for (int t = 0; t < n; t += 8)
            if (single) std::copy_n(single + t, 8, to + t);
            else std::copy_n(exact + t, 8, to + t);
    }
};

template<int dim> class NeighbourLists
{
public:
    static constexpr int lanes = 8;
    /// More neighbours than this mean particles on top of one another, and end in an error.
    static constexpr int mostNeighbours = 1024;

    enum class Stored
    {
        yes,
        no
    };

    /// Lists the first `owned` of the particles 0 .. total - 1; index `total` is the null particle. Throws CaseError, with the position,
    /// where a particle has more than mostNeighbours. Where lists are not stored, the positions must stay as they are. `room` is memory that nobody else
    /// uses meanwhile, and may be too small.
    void build(const std::array<const double*, dim>& x, std::size_t owned, std::size_t total, double radius, Stored stored = Stored::yes,
               std::span<double> room = {});

    /// Memory of one list; uninitialised.
    struct Room
    {
        alignas(64) int entries[mostNeighbours + 2 * lanes];
    };
    /// The list, in the room.
    std::span<const int> of(std::size_t i, Room& room) const
    {
        if (chunks_.empty()) return found(i, room);
        const Chunk& c = chunks_[i / chunkSize];
        const unsigned begin = c.begin[i % chunkSize];
        const int n = int(c.begin[i % chunkSize + 1] - begin);
        c.unpack(begin, n, room.entries);
        return padded(room, n);
    }
    /// Whether some stored list names a particle that is not owned, for each of those; until they are renumbered.
    std::span<const char> seen() const { return seen_; }
    /// Gives what is not owned other numbers in stored lists: numbers[k] to particle owned + k, the last of them to the null particle. What lists name keeps its order.
    void renumber(std::span<const int> numbers);
    /// Length of a stored list, without padding.
    std::size_t sizeOf(std::size_t i) const
    {
        const Chunk& c = chunks_[i / chunkSize];
        return c.begin[i % chunkSize + 1] - c.begin[i % chunkSize];
    }
    /// Neighbours within the support that a pass found, kept for later passes: they need not look at the skin again. `makeRoomWithin` is called once before
    /// a loop of `keepWithin`; n is a multiple of the lanes.
    void makeRoomWithin();
    void keepWithin(std::size_t i, const int* j, int n)
    {
        Chunk& c = chunks_[i / chunkSize];
        std::copy_n(j, n, c.within.data() + c.withinBegin(i % chunkSize));
        c.withinCount[i % chunkSize] = n;
    }
    std::span<const int> within(std::size_t i) const
    {
        const Chunk& c = chunks_[i / chunkSize];
        return {c.within.data() + c.withinBegin(i % chunkSize), std::size_t(c.withinCount[i % chunkSize])};
    }
    /// (dW/dr)/r of those pairs, one number for each entry of `within(i)`, likewise: room is made before a loop that writes them, in one of the two
    /// precisions; what was kept in the other is gone.
    void makeRoomForSlopes(bool inSinglePrecision);
    KeptSlopes slopes(std::size_t i)
    {
        Chunk& c = chunks_[i / chunkSize];
        const auto first = c.withinBegin(i % chunkSize);
        return {c.slopes.empty() ? nullptr : c.slopes.data() + first, c.singleSlopes.empty() ? nullptr : c.singleSlopes.data() + first};
    }
    /// Has the processor fetch what is kept of the pairs of a particle, some turns before they are read: each of these streams ends before it would follow.
    void fetchKept(std::size_t i)
    {
        const auto list = within(i);
        const auto kept = slopes(i);
        const auto fetch = [n = list.size()](const auto* from)
        {
            if (!from || n == 0) return;
            constexpr std::size_t line = 64 / sizeof *from;
            for (std::size_t t = 0; t < n; t += line) __builtin_prefetch(from + t);
            __builtin_prefetch(from + n - 1); // they begin anywhere in a line
        };
        fetch(list.data());
        fetch(kept.exact);
        fetch(kept.single);
    }
    /// Each build of stored lists from now on divides the owned particles into those whose neighbours are all owned, and the others, both ascending: the former
    /// are those that a rank can compute before it has heard of the others.
    void partInterior() { partsInterior_ = true; }
    std::span<const int> interior() const { return interior_; }
    std::span<const int> border() const { return border_; }
    /// Number of pairs without padding, self included.
    std::size_t pairs() const { return pairs_; }
    std::size_t bytes() const;

private:
    /// Particles listed by one thread at a time into a buffer of their own. Few enough for the pages of one set: those of 256 see less than two rows more
    /// than those around one of them, in a scene of 10^7.
    static constexpr std::size_t chunkSize = 256;
    struct Chunk
    {
        std::vector<std::uint16_t> codes;
        std::vector<int> wide; ///< the indices themselves, where they take too many pages: then there are no codes
        IndexPages pages;
        std::array<unsigned, chunkSize + 1> begin; ///< of each list
        bool namesOthers;                          ///< that are not owned
        IndexArray within, withinCount;            ///< none where no pass keeps
        Array slopes;                              ///< likewise
        SingleArray singleSlopes;                  ///< in place of slopes
        /// Indices from place `first` on; `to` needs room for 7 more.
        void unpack(unsigned first, int n, int* to) const
        {
            if (wide.empty()) unpackIndices(codes.data() + first, n, pages, to);
            else std::copy_n(wide.data() + first, n, to);
        }
        void pack(IndexPacker&, std::span<const int> indices, std::size_t total);
        /// Lists within the support are padded.
        std::size_t withinBegin(std::size_t k) const { return begin[k] + k * lanes; }
    };
    std::vector<Chunk> chunks_; ///< none where lists are not stored
    CellList<dim> cells_;       ///< as sorted_
    std::array<const double*, dim> x_{};
    WholePlaces<dim> places_;
    std::vector<int> ownSorted_;
    SortedPoints<dim> sorted_{}; ///< until the end of the build, where lists are stored
    bool partsInterior_ = false;
    std::vector<int> interior_, border_;
    std::vector<char> seen_;
    std::size_t owned_ = 0;
    double radius_ = 0;
    int nullParticle_ = 0;
    std::size_t pairs_ = 0;

    std::span<const int> padded(Room& room, int n) const
    {
        for (int k = 0; k < lanes; ++k) room.entries[n + k] = nullParticle_;
        return {room.entries, std::size_t((n + lanes - 1) / lanes * lanes)};
    }
    /// Notes who is seen; whether any is not owned.
    bool see(std::span<const int> list);
    void sortPlaces(std::size_t total, std::span<double> room);
    /// Writes the list of a place in a cell, of which these are the runs around. Returns how many it holds; `to` needs room for 16 more.
    int find(Vector<dim> x, const std::vector<typename CellList<dim>::Run>& runs, int* to) const;
    std::span<const int> found(std::size_t i, Room&) const;
};

}
