#include "neighbours/NeighbourLists.hpp"
#include "base/CaseError.hpp"
#include "parallel/Stretches.hpp"
#include <atomic>
#include <fmt/format.h>

namespace sph
{

template<int dim> void NeighbourLists<dim>::sortPlaces(std::size_t total, std::span<double> room)
{
    const std::size_t each = total + SortedPoints<dim>::readBeyond, all = (dim + 1) * each;
    int* to = reinterpret_cast<int*>(room.data());
    if (room.size_bytes() < all * sizeof(int))
    {
        ownSorted_.resize(all);
        to = ownSorted_.data();
    }
    places_ = WholePlaces<dim>(cells_.low(), cells_.extent(), radius_);
    const auto& order = cells_.order();
    for (int c = 0; c < dim; ++c)
    {
        int* const place = to + std::size_t(c) * each;
#pragma omp parallel for schedule(static)
        for (std::size_t k = 0; k < total; ++k) place[k] = places_(c, x_[c][order[k]]);
        std::fill_n(place + total, SortedPoints<dim>::readBeyond, 0);
        sorted_.place[c] = place;
    }
    int* const index = to + dim * each;
#pragma omp parallel for schedule(static)
    for (std::size_t k = 0; k < total; ++k) index[k] = order[k];
    std::fill_n(index + total, SortedPoints<dim>::readBeyond, 0);
    sorted_.index = index;
}

template<int dim> int NeighbourLists<dim>::find(Vector<dim> x, const std::vector<typename CellList<dim>::Run>& runs, int* to) const
{
    const auto place = places_(x);
    const float limit = places_.limit(radius_);
    int n = 0;
    for (const auto& r : runs) n += selectWithin<dim>(sorted_, r.begin, r.end, place, limit, to + n);
    return n;
}

/// Marks the particles of a list as seen, by several threads at once. No branch: in a bed owned particles and images take turns in a list.
template<int dim> bool NeighbourLists<dim>::see(std::span<const int> list)
{
    char ofOwned = 0;
    bool any = false;
    for (const int j : list)
    {
        const bool owned = std::size_t(j) < owned_;
        char* const seen = owned ? &ofOwned : &seen_[std::size_t(j) - owned_];
        std::atomic_ref(*seen).store(1, std::memory_order_relaxed);
        any |= !owned;
    }
    return any;
}

template<int dim> std::span<const int> NeighbourLists<dim>::found(std::size_t i, Room& room) const
{
    static thread_local std::vector<typename CellList<dim>::Run> runs;
    const auto x = valueAt<Vector<dim>>(x_, i);
    cells_.runsAround(cells_.cellOf(x), radius_, runs);
    return padded(room, find(x, runs, room.entries));
}

/// Room for codes is kept from one build to the next.
template<int dim> void NeighbourLists<dim>::Chunk::pack(IndexPacker& packer, std::span<const int> indices, std::size_t total)
{
    const std::size_t size = indices.size() + lanes;
    if (size > codes.capacity())
    {
        codes = std::vector<std::uint16_t>();
        codes.reserve(size + size / 50);
    }
    codes.resize(size);
    wide = std::vector<int>();
    if (packer.pack(indices, total, pages, codes.data())) return;
    codes = std::vector<std::uint16_t>();
    wide.assign(indices.begin(), indices.end());
}

template<int dim> void NeighbourLists<dim>::renumber(std::span<const int> numbers)
{
    nullParticle_ = numbers.back();
    const auto write = [&](std::size_t first, std::size_t end)
    {
        static thread_local std::vector<int> indices;
        static thread_local IndexPacker packer;
        for (std::size_t chunk = first; chunk < end; ++chunk)
        {
            Chunk& c = chunks_[chunk];
            if (!c.namesOthers) continue;
            const unsigned n = c.begin.back();
            indices.resize(std::max(indices.size(), std::size_t(n) + lanes));
            c.unpack(0, int(n), indices.data());
            int* const j = indices.data();
#pragma omp simd
            for (unsigned t = 0; t < n; ++t)
                if (const int k = j[t] - int(owned_); k >= 0) j[t] = numbers[std::size_t(k)];
            c.pack(packer, {indices.data(), n}, std::size_t(nullParticle_));
        }
    };
    Stretches stretches(chunks_.size(), 1);
#pragma omp parallel
    stretches.forEach(write);
    seen_.clear();
}

template<int dim>
void NeighbourLists<dim>::build(const std::array<const double*, dim>& x, std::size_t owned, std::size_t total, double radius, Stored stored,
                                std::span<double> room)
{
    // Half the radius: 5^dim cells hold 40 % fewer candidates than 3^dim cells of the full radius.
    cells_.build(x, total, 0.5 * radius);
    owned_ = owned;
    nullParticle_ = int(total);
    radius_ = radius;
    x_ = x;
    sortPlaces(total, stored == Stored::yes ? room : std::span<double>());

    const std::size_t chunks = (owned + chunkSize - 1) / chunkSize;
    chunks_.resize(stored == Stored::yes ? chunks : 0);
    seen_.assign(stored == Stored::yes ? total - owned : 0, 0);
    std::vector<char> seesOthers(partsInterior_ ? owned : 0);
    std::size_t crowded = total;
    pairs_ = 0;
    const auto list = [&](std::size_t begin, std::size_t end)
    {
        std::vector<typename CellList<dim>::Run> runs;
        static thread_local std::vector<int> indices; // lists take what they need, and no more
        static thread_local IndexPacker packer;
        std::array<unsigned, chunkSize + 1> beginOf;
        for (std::size_t chunk = begin; chunk < end; ++chunk)
        {
            unsigned used = 0;
            typename CellList<dim>::Cell last;
            last.fill(-1);
            std::size_t candidates = 0;
            bool namesOthers = false;
            for (std::size_t i = chunk * chunkSize; i < std::min(owned, (chunk + 1) * chunkSize); ++i)
            {
                const auto x_i = valueAt<Vector<dim>>(x, i);
                if (const auto cell = cells_.cellOf(x_i); cell != last)
                {
                    cells_.runsAround(cell, radius, runs);
                    last = cell;
                    candidates = 0;
                    for (const auto& r : runs) candidates += r.end - r.begin;
                }
                if (used + candidates + 2 * lanes > indices.size()) indices.resize(used + used / 2 + 8 * candidates + 2 * lanes);
                beginOf[i % chunkSize] = used;
                int n = find(x_i, runs, indices.data() + used);
                if (n > mostNeighbours)
                {
#pragma omp critical
                    crowded = std::min(crowded, i);
                    n = mostNeighbours;
                }
                if (!seen_.empty() && see({indices.data() + used, std::size_t(n)}))
                {
                    namesOthers = true;
                    if (partsInterior_) seesOthers[i] = 1;
                }
                used += unsigned(n);
            }
            std::fill(beginOf.begin() + std::ptrdiff_t(std::min(owned - chunk * chunkSize, chunkSize)), beginOf.end(), used);
#pragma omp atomic
            pairs_ += used;
            if (stored == Stored::no) continue;
            Chunk& out = chunks_[chunk];
            out.begin = beginOf;
            out.namesOthers = namesOthers;
            out.pack(packer, {indices.data(), used}, total);
        }
    };
    Stretches stretches(chunks, 1);
#pragma omp parallel
    stretches.forEach(list);
    interior_.clear();
    border_.clear();
    for (std::size_t i = 0; i < seesOthers.size(); ++i) (seesOthers[i] ? border_ : interior_).push_back(int(i));
    if (stored == Stored::yes)
    {
        ownSorted_ = std::vector<int>();
        sorted_ = {};
        cells_ = {};
    }
    if (crowded < total)
    {
        const auto p = valueAt<Vector<dim>>(x, crowded);
        const auto q = in3D(p);
        throw CaseError(
            fmt::format("particle {} at ({:.6g} {:.6g} {:.6g}) has more than {} neighbours: particles lie on top of one another, "
                        "or the kernel support is too many spacings",
                        crowded, q.x, q.y, q.z, mostNeighbours));
    }
}

namespace
{
/// Room for so many numbers, of any value.
void makeRoom(auto& array, std::size_t size)
{
    if (array.size() >= size) return;
    array.clear(); // nothing is copied
    array.resize(size);
}
}

template<int dim> void NeighbourLists<dim>::makeRoomWithin()
{
#pragma omp parallel for schedule(static)
    for (Chunk& c : chunks_)
    {
        makeRoom(c.within, c.withinBegin(chunkSize));
        makeRoom(c.withinCount, chunkSize);
    }
}

template<int dim> void NeighbourLists<dim>::makeRoomForSlopes(bool inSinglePrecision)
{
#pragma omp parallel for schedule(static)
    for (Chunk& c : chunks_)
    {
        const std::size_t pairs = c.withinBegin(chunkSize);
        if (inSinglePrecision)
        {
            c.slopes = Array();
            makeRoom(c.singleSlopes, pairs);
        }
        else
        {
            c.singleSlopes = SingleArray();
            makeRoom(c.slopes, pairs);
        }
    }
}

template<int dim> std::size_t NeighbourLists<dim>::bytes() const
{
    std::size_t n = (interior_.capacity() + border_.capacity()) * sizeof(int) + seen_.capacity();
    for (const auto& c : chunks_)
        n += sizeof(Chunk) + c.codes.capacity() * sizeof(std::uint16_t) +
             (c.wide.capacity() + c.within.capacity() + c.withinCount.capacity()) * sizeof(int) + c.slopes.capacity() * sizeof(double) +
             c.singleSlopes.capacity() * sizeof(float);
    return n;
}

template class NeighbourLists<2>;
template class NeighbourLists<3>;

}
