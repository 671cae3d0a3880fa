#include "meshes/cleanSoup.hpp"
#include "geometry/Shape.hpp"
#include "meshes/WeldedPoints.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <numeric>
#include <unordered_map>

namespace sph
{

namespace
{

void turn(NumberedMesh& m, std::size_t facet) { std::swap(m.triangles[facet][1], m.triangles[facet][2]); }

/// Points in which parts meet become one point for each of them; corners that facets of a pair share belong together. Their number.
std::size_t part(NumberedMesh& m, const auto& pairsOf)
{
    DisjointSets corners(3 * m.triangles.size());
    const auto corner = [&](int facet, int point)
    {
        const auto& t = m.triangles[std::size_t(facet)];
        return 3 * facet + int(std::find(t.begin(), t.end(), point) - t.begin());
    };
    forEachEdge(sortedHalfEdges(m),
                [&](std::span<const HalfEdge> edge)
                {
                    for (const auto& [a, b] : pairsOf(edge))
                        for (const int p : {a.low, a.high}) corners.join(corner(a.facet, p), corner(b.facet, p));
                });
    std::vector<int> fanOf(m.points.size(), -1);
    std::unordered_map<int, int> more; // fans beyond the first of their point, and the points they get
    std::size_t split = 0;
    std::vector<char> isSplit(m.points.size(), 0);
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
        {
            const int p = m.triangles[f][k], fan = corners.find(int(3 * f + k));
            auto& first = fanOf[std::size_t(p)];
            if (first < 0) first = fan;
            if (first == fan) continue;
            const auto [place, isNew] = more.try_emplace(fan, int(m.points.size()));
            if (isNew) m.points.push_back(m.points[std::size_t(p)]);
            if (!isSplit[std::size_t(p)]++) ++split;
            m.triangles[f][k] = place->second;
        }
    return split;
}

/// Facets of an edge by twos: those between which solid lies, by their orientation; where that does not tell, those of one region. None
/// where neither does.
std::vector<std::array<HalfEdge, 2>> pairsAt(const NumberedMesh& m, std::span<const HalfEdge> edge)
{
    std::vector<std::array<HalfEdge, 2>> pairs;
    const auto forward = std::count_if(edge.begin(), edge.end(), [](const HalfEdge& h) { return h.forward; });
    if (2 * std::size_t(forward) != edge.size())
    {
        if (edge.size() == 2) return {{edge[0], edge[1]}};
        std::map<int, std::vector<HalfEdge>> ofRegion;
        for (const auto& h : edge) ofRegion[m.region[std::size_t(h.facet)]].push_back(h);
        for (const auto& [_, facets] : ofRegion)
        {
            if (facets.size() != 2) return {};
            pairs.push_back({facets[0], facets[1]});
        }
        return pairs;
    }
    // Counter-clockwise around the edge, solid begins at a facet that goes backwards along it and ends at one that goes forwards.
    const auto from = m.points[std::size_t(edge[0].low)], along = unitVector(m.points[std::size_t(edge[0].high)] - from);
    const auto across = [&](const HalfEdge& h)
    {
        const auto r = centroid(m, h.facet) - from;
        return r - dot(r, along) * along;
    };
    const auto u = unitVector(across(edge[0])), v = cross(along, u);
    std::vector<std::pair<double, HalfEdge>> around;
    for (const auto& h : edge) around.emplace_back(std::atan2(dot(across(h), v), dot(across(h), u)), h);
    std::stable_sort(around.begin(), around.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    // As brackets: from behind the place where most have ended, each end belongs to the last beginning before it.
    int depth = 0, least = 0;
    std::size_t start = 0;
    for (std::size_t i = 0; i < around.size(); ++i)
    {
        depth += around[i].second.forward ? -1 : 1;
        if (depth < least)
        {
            least = depth;
            start = i + 1;
        }
    }
    std::vector<HalfEdge> open;
    for (std::size_t i = 0; i < around.size(); ++i)
    {
        const auto& h = around[(start + i) % around.size()].second;
        if (!h.forward) open.push_back(h);
        else
        {
            pairs.push_back({open.back(), h});
            open.pop_back();
        }
    }
    return pairs;
}

/// Cuts the facet of a half-edge in two at a point on it.
void divide(NumberedMesh& m, const HalfEdge& h, int point)
{
    auto& t = m.triangles[std::size_t(h.facet)];
    std::rotate(t.begin(), std::find(t.begin(), t.end(), h.forward ? h.low : h.high), t.end());
    const std::array<int, 3> other{point, t[1], t[2]};
    t[1] = point;
    m.triangles.push_back(other);
    m.region.push_back(m.region[std::size_t(h.facet)]);
    m.number.push_back(m.number[std::size_t(h.facet)]);
}

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
    WeldedPoints kept(tolerance, boundingBox(m));
    std::vector<int> place;
    place.reserve(m.points.size());
    for (const auto& x : m.points) place.push_back(kept.add(x));
    if (kept.all().size() < m.points.size())
        repairs.push_back(
            fmt::format("{} points welded to {}: those within {:.3g} m of each other", m.points.size(), kept.all().size(), tolerance));
    m.points = kept.all();
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
    bool bodiesTouch = true; // and can be united: each edge then parts to them
    forEachEdge(sortedHalfEdges(m),
                [&](std::span<const HalfEdge> edge)
                {
                    if (edge.size() <= 2) return;
                    bodiesTouch = bodiesTouch && !pairsAt(m, edge).empty();
                    for (const auto& h : edge)
                    {
                        edges.push_back({h.low, h.high});
                        facets.push_back(h.facet);
                    }
                });
    if (!edges.empty())
        throw UnusableMesh("the surface is not manifold: more than two facets meet in an edge", m, edges, facets,
                           bodiesTouch
                               ? "If bodies touch there, unite them: removeSelfIntersections yes; or wrap them: wrap { tolerance ...; }"
                               : "Separate the parts that touch there, or wrap them: wrap { tolerance ...; }");
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
    const auto split = part(
        m,
        [](std::span<const HalfEdge> edge) {
            return edge.size() == 2 ? std::vector<std::array<HalfEdge, 2>>{{edge[0], edge[1]}} : std::vector<std::array<HalfEdge, 2>>{};
        });
    if (split > 0) repairs.push_back(counted(split, "point") + " in which parts touch split, one for each part");
}

void splitEdges(NumberedMesh& m)
{
    const auto pairsOf = [&](std::span<const HalfEdge> edge) { return pairsAt(m, edge); };
    const auto isShared = [&](std::span<const HalfEdge> edge) { return edge.size() > 2 && !pairsOf(edge).empty(); };
    const auto anyIsShared = [&]
    {
        bool any = false;
        forEachEdge(sortedHalfEdges(m), [&](std::span<const HalfEdge> edge) { any = any || isShared(edge); });
        return any;
    };
    if (!anyIsShared()) return;
    part(m, pairsOf);
    // An edge whose ends lie within parts that go on around them stays; a point in its middle for each part divides it.
    while (anyIsShared())
    {
        std::vector<char> divided(m.triangles.size(), 0);
        forEachEdge(sortedHalfEdges(m),
                    [&](std::span<const HalfEdge> edge)
                    {
                        if (!isShared(edge)) return;
                        if (std::any_of(edge.begin(), edge.end(), [&](const HalfEdge& h) { return divided[std::size_t(h.facet)]; })) return;
                        for (const auto& pair : pairsOf(edge))
                        {
                            const int middle = int(m.points.size());
                            m.points.push_back(0.5 * (m.points[std::size_t(pair[0].low)] + m.points[std::size_t(pair[0].high)]));
                            for (const auto& h : pair)
                            {
                                divided[std::size_t(h.facet)] = 1;
                                divide(m, h, middle);
                            }
                        }
                    });
    }
}

}
