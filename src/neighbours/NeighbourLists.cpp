#include "NeighbourLists.hpp"
#include "CaseError.hpp"
#include "Stretches.hpp"
#include "select.hpp"
#include <fmt/format.h>

namespace sph
{

template<int dim>
void NeighbourLists<dim>::build(const std::array<const double*, dim>& x, std::size_t owned, std::size_t total, double radius)
{
    // Half the radius: 5^dim cells hold 40 % fewer candidates than 3^dim cells of the full radius.
    cells_.build(x, total, 0.5 * radius);
    owned_ = owned;
    nullParticle_ = int(total);
    chunks_.resize((owned + chunkSize - 1) / chunkSize);
    std::array<Array, dim> sorted;
    const double* position[dim];
    for (int c = 0; c < dim; ++c)
    {
        sorted[c].resize(total);
#pragma omp parallel for schedule(static)
        for (std::size_t k = 0; k < total; ++k) sorted[c][k] = x[c][cells_.order()[k]];
        position[c] = sorted[c].data();
    }

    std::size_t crowded = total;
    const auto list = [&](std::size_t begin, std::size_t end)
    {
        std::vector<typename CellList<dim>::Run> runs;
        static thread_local std::vector<int> room; // lists take what they need, and no more
        for (std::size_t chunk = begin; chunk < end; ++chunk)
        {
            Chunk& out = chunks_[chunk];
            out.pairs = 0;
            unsigned used = 0;
            typename CellList<dim>::Cell last;
            last.fill(-1);
            std::size_t candidates = 0;
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
                if (used + candidates + 2 * lanes > room.size()) room.resize(used + used / 2 + 8 * candidates + 2 * lanes);
                out.begin[i % chunkSize] = used;
                int* const entries = room.data() + used;
                int n = 0;
                for (const auto& r : runs)
                    n += selectWithin<dim>(position, cells_.order().data(), r.begin, r.end, x_i, sqr(radius), entries + n);
                out.pairs += n;
                if (n > mostNeighbours)
                {
#pragma omp critical
                    crowded = std::min(crowded, i);
                    n = mostNeighbours;
                }
                while (n % lanes) entries[n++] = int(total);
                used += n;
                out.begin[i % chunkSize + 1] = used;
            }
            if (used > out.entries.capacity()) out.entries.reserve(used + used / 50);
            out.entries.assign(room.begin(), room.begin() + used);
        }
    };
    Stretches stretches(chunks_.size(), 1);
#pragma omp parallel
    stretches.forEach(list);
    if (crowded < total)
    {
        const auto p = valueAt<Vector<dim>>(x, crowded);
        const auto q = in3D(p);
        throw CaseError(
            fmt::format("particle {} at ({:.6g} {:.6g} {:.6g}) has more than {} neighbours: particles lie on top of one another, "
                        "or the kernel support is too many spacings",
                        crowded, q.x, q.y, q.z, mostNeighbours));
    }
    pairs_ = 0;
    for (const auto& c : chunks_) pairs_ += c.pairs;
}

template<int dim> std::vector<char> NeighbourLists<dim>::seen() const
{
    std::vector<char> seen(std::size_t(nullParticle_) + 1);
    for (const auto& c : chunks_)
        for (const int j : c.entries) seen[std::size_t(j)] = true;
    return seen;
}

template<int dim> void NeighbourLists<dim>::renumber(std::span<const int> place)
{
#pragma omp parallel for schedule(static)
    for (auto& c : chunks_)
        for (int& j : c.entries) j = place[std::size_t(j)];
    nullParticle_ = place.back();
}

template<int dim> void NeighbourLists<dim>::makeRoomWithin()
{
    for (auto& c : chunks_)
    {
        if (c.within.size() < c.entries.size()) c.within.resize(c.entries.size());
        c.withinCount.resize(chunkSize);
    }
}

template<int dim> void NeighbourLists<dim>::partInterior()
{
    std::vector<char> seesImages(owned_);
#pragma omp parallel for schedule(static)
    for (std::size_t i = 0; i < owned_; ++i)
        seesImages[i] = std::ranges::any_of(of(i), [&](int j) { return j >= int(owned_) && j != nullParticle_; });
    interior_.clear();
    border_.clear();
    for (std::size_t i = 0; i < owned_; ++i) (seesImages[i] ? border_ : interior_).push_back(int(i));
}

template<int dim> std::size_t NeighbourLists<dim>::bytes() const
{
    std::size_t n = (interior_.capacity() + border_.capacity()) * sizeof(int);
    for (const auto& c : chunks_)
        n += sizeof(Chunk) + (c.entries.capacity() + c.within.capacity() + c.withinCount.capacity()) * sizeof(int);
    return n;
}

template class NeighbourLists<2>;
template class NeighbourLists<3>;

}
