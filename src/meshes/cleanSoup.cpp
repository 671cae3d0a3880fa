#include "cleanSoup.hpp"
#include "Shape.hpp"
#include <algorithm>
#include <cstdint>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <unordered_map>

namespace sph
{

namespace
{

/// Keeps the facets for which `keep(facet)` holds; their number.
std::size_t dropFacets(NumberedMesh& m, const auto& keep)
{
    std::size_t kept = 0;
    const auto before = m.triangles.size();
    for (std::size_t f = 0; f < before; ++f)
    {
        if (!keep(f)) continue;
        m.triangles[kept] = m.triangles[f];
        m.region[kept] = m.region[f];
        m.number[kept++] = m.number[f];
    }
    m.triangles.resize(kept);
    m.region.resize(kept);
    m.number.resize(kept);
    return before - kept;
}

void turn(NumberedMesh& m, std::size_t facet) { std::swap(m.triangles[facet][1], m.triangles[facet][2]); }

}

void removeUnusedPoints(NumberedMesh& m)
{
    std::vector<int> place(m.points.size(), -1);
    for (const auto& t : m.triangles)
        for (const int p : t) place[std::size_t(p)] = 0;
    int kept = 0;
    for (std::size_t p = 0; p < m.points.size(); ++p)
        if (place[p] == 0)
        {
            m.points[std::size_t(kept)] = m.points[p];
            place[p] = kept++;
        }
    m.points.resize(std::size_t(kept));
    for (auto& t : m.triangles)
        for (int& p : t) p = place[std::size_t(p)];
}

void weldPoints(NumberedMesh& m, double tolerance, std::vector<std::string>& repairs)
{
    // Cells of the tolerance's width: what is near is in the same cell or in the next one.
    const auto low = boundingBox(m).low;
    const double width = std::max(tolerance, std::numeric_limits<double>::min());
    const auto cell = [&](double x, double from) { return std::int64_t(std::floor((x - from) / width)); };
    const auto key = [](std::int64_t i, std::int64_t j, std::int64_t k)
    { return std::uint64_t(i) * 0x9E3779B97F4A7C15u ^ std::uint64_t(j) * 0xC2B2AE3D27D4EB4Fu ^ std::uint64_t(k) * 0x165667B19E3779F9u; };

    std::unordered_map<std::uint64_t, int> first; // of the points of a cell; the others follow by `next`
    first.reserve(m.points.size());
    std::vector<int> next, place(m.points.size());
    std::vector<Vector<3>> kept;
    for (std::size_t p = 0; p < m.points.size(); ++p)
    {
        const auto x = m.points[p];
        const std::int64_t i = cell(x.x, low.x), j = cell(x.y, low.y), k = cell(x.z, low.z);
        int same = -1;
        const auto look = [&](std::int64_t di, std::int64_t dj, std::int64_t dk)
        {
            const auto there = first.find(key(i + di, j + dj, k + dk));
            if (there == first.end()) return;
            for (int q = there->second; q >= 0 && same < 0; q = next[std::size_t(q)])
                if (mag(kept[std::size_t(q)] - x) <= tolerance) same = q;
        };
        look(0, 0, 0);
        for (int n = 0; n < 27 && same < 0; ++n)
            if (n != 13) look(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        if (same < 0)
        {
            same = int(kept.size());
            kept.push_back(x);
            const auto [entry, isNew] = first.try_emplace(key(i, j, k), same);
            next.push_back(isNew ? -1 : entry->second);
            entry->second = same;
        }
        place[p] = same;
    }
    if (kept.size() < m.points.size())
        repairs.push_back(
            fmt::format("{} points welded to {}: those within {:.3g} m of each other", m.points.size(), kept.size(), tolerance));
    m.points = std::move(kept);
    for (auto& t : m.triangles)
        for (int& p : t) p = place[std::size_t(p)];
    const auto dropped = dropFacets(m,
                                    [&](std::size_t f)
                                    {
                                        const auto& [a, b, c] = m.triangles[f];
                                        return a != b && b != c && c != a;
                                    });
    if (dropped > 0) repairs.push_back(counted(dropped, "facet") + " with two corners in one point removed");
    removeUnusedPoints(m);
}

void removeDuplicates(NumberedMesh& m, std::vector<std::string>& repairs)
{
    // Corners in ascending order, and whether that is an even permutation: opposite facets differ in it.
    struct Corners
    {
        std::array<int, 3> sorted;
        int facet;
        bool even;
    };
    std::vector<Corners> all(m.triangles.size());
    for (std::size_t f = 0; f < all.size(); ++f)
    {
        auto t = m.triangles[f];
        std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
        const bool even = t[1] < t[2];
        std::sort(t.begin(), t.end());
        all[f] = {t, int(f), even};
    }
    std::sort(all.begin(), all.end(),
              [](const Corners& a, const Corners& b) { return a.sorted != b.sorted ? a.sorted < b.sorted : a.facet < b.facet; });
    std::vector<char> keep(all.size(), 1);
    std::size_t twice = 0, opposite = 0;
    for (std::size_t i = 0, j = 0; i < all.size(); i = j)
    {
        std::size_t even = 0;
        for (j = i; j < all.size() && all[j].sorted == all[i].sorted; ++j) even += all[j].even;
        const auto count = j - i;
        const bool cancel = count > 1 && 2 * even == count;
        for (auto k = cancel ? i : i + 1; k < j; ++k) keep[std::size_t(all[k].facet)] = 0;
        (cancel ? opposite : twice) += cancel ? count : count - 1;
    }
    if (twice + opposite == 0) return;
    dropFacets(m, [&](std::size_t f) { return keep[f]; });
    removeUnusedPoints(m);
    if (twice > 0) repairs.push_back(counted(twice, "facet") + " that another one covers removed");
    if (opposite > 0) repairs.push_back(counted(opposite, "facet") + " that lie back to back removed");
}

void checkManifold(const NumberedMesh& m)
{
    std::vector<std::array<int, 2>> edges;
    std::vector<int> facets;
    forEachEdge(sortedHalfEdges(m),
                [&](std::span<const HalfEdge> edge)
                {
                    if (edge.size() <= 2) return;
                    for (const auto& h : edge)
                    {
                        edges.push_back({h.low, h.high});
                        facets.push_back(h.facet);
                    }
                });
    if (!edges.empty())
        throw UnusableMesh("the surface is not manifold: more than two facets meet in an edge", m, edges, facets,
                           "Separate the parts that touch there, or wrap them: wrap { tolerance ...; }");
}

void orientFacets(NumberedMesh& m, std::vector<std::string>& repairs)
{
    struct Neighbour
    {
        int facet = -1;
        bool sameWay = false; ///< both go through the edge in one direction
    };
    std::vector<std::array<Neighbour, 3>> neighbours(m.triangles.size());
    const auto slot = [&](const HalfEdge& h)
    {
        const auto& t = m.triangles[std::size_t(h.facet)];
        const int from = h.forward ? h.low : h.high;
        return std::size_t(std::find(t.begin(), t.end(), from) - t.begin());
    };
    forEachEdge(sortedHalfEdges(m),
                [&](std::span<const HalfEdge> edge)
                {
                    if (edge.size() != 2) return;
                    const bool sameWay = edge[0].forward == edge[1].forward;
                    neighbours[std::size_t(edge[0].facet)][slot(edge[0])] = {edge[1].facet, sameWay};
                    neighbours[std::size_t(edge[1].facet)][slot(edge[1])] = {edge[0].facet, sameWay};
                });

    std::vector<signed char> turned(m.triangles.size(), -1);
    std::size_t total = 0;
    std::vector<int> part;
    for (std::size_t seed = 0; seed < turned.size(); ++seed)
    {
        if (turned[seed] >= 0) continue;
        part.assign(1, int(seed));
        turned[seed] = 0;
        std::size_t count = 0;
        for (std::size_t next = 0; next < part.size(); ++next)
        {
            const auto f = std::size_t(part[next]);
            count += turned[f] == 1;
            for (std::size_t k = 0; k < 3; ++k)
            {
                const auto& [other, sameWay] = neighbours[f][k];
                if (other < 0) continue;
                const signed char should = sameWay ? !turned[f] : turned[f];
                auto& is = turned[std::size_t(other)];
                if (is < 0)
                {
                    is = should;
                    part.push_back(other);
                }
                else if (is != should)
                    throw UnusableMesh("the surface has one side only, as a Moebius strip: neighbours cannot be given the same orientation",
                                       m, std::vector<std::array<int, 2>>{{m.triangles[f][k], m.triangles[f][(k + 1) % 3]}},
                                       std::vector<int>{int(f)});
            }
        }
        const bool mostWere = 2 * count > part.size();
        for (const int f : part)
            if (bool(turned[std::size_t(f)]) != mostWere)
            {
                turn(m, std::size_t(f));
                ++total;
            }
    }
    if (total > 0) repairs.push_back(counted(total, "facet") + " turned, so that neighbours agree");
}

void splitPoints(NumberedMesh& m, std::vector<std::string>& repairs)
{
    // Corners of facets, joined across the edges that their facets share.
    DisjointSets corners(3 * m.triangles.size());
    const auto corner = [&](int facet, int point)
    {
        const auto& t = m.triangles[std::size_t(facet)];
        return 3 * facet + int(std::find(t.begin(), t.end(), point) - t.begin());
    };
    forEachEdge(sortedHalfEdges(m),
                [&](std::span<const HalfEdge> edge)
                {
                    if (edge.size() != 2) return;
                    for (const int p : {edge[0].low, edge[0].high}) corners.join(corner(edge[0].facet, p), corner(edge[1].facet, p));
                });
    std::vector<int> fanOf(m.points.size(), -1);
    std::unordered_map<int, int> more; // fans beyond the first of their point, and the points they get
    std::size_t split = 0;
    std::vector<char> counted_(m.points.size(), 0);
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
        {
            const int p = m.triangles[f][k], fan = corners.find(int(3 * f + k));
            auto& first = fanOf[std::size_t(p)];
            if (first < 0) first = fan;
            if (first == fan) continue;
            const auto [place, isNew] = more.try_emplace(fan, int(m.points.size()));
            if (isNew) m.points.push_back(m.points[std::size_t(p)]);
            if (!counted_[std::size_t(p)]++) ++split;
            m.triangles[f][k] = place->second;
        }
    if (split > 0) repairs.push_back(counted(split, "point") + " in which parts touch split, one for each part");
}

}
