#include "geometry/components.hpp"
#include "meshes/FacetSoup.hpp"
#include "meshes/cleanSoup.hpp"
#include "meshes/orientShells.hpp"
#include "meshes/repairSurface.hpp"
#include "meshes/windings.hpp"
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <random>
#include <stdexcept>

namespace sph
{

namespace
{

/// Number of turns of each closed surface (by its number) around a point; those without any are left out.
using Windings = std::map<int, int>;

void add(Windings& w, int shell, int times)
{
    if ((w[shell] += times) == 0) w.erase(shell);
}

/// Facets that meet in common points and edges alone, each once, with the closed surfaces that it is a part of.
struct Sheets : TriangleSurface
{
    std::vector<Windings> crossed; ///< winding numbers behind the facet minus those before it
    std::vector<int> source;       ///< triangle of the mesh
    std::vector<int> patch;        ///< facets joined by edges of two facets: winding numbers on both sides are the same all over it
    int patches = 0;
};

Sheets sheetsOf(const FacetSoup& soup, const Shells& shells)
{
    Sheets sheets;
    sheets.points = soup.points.all();
    std::map<std::array<int, 3>, int> known;
    for (std::size_t f = 0; f < soup.facets.size(); ++f)
    {
        auto corners = soup.facets[f];
        std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
        auto sorted = corners;
        std::sort(sorted.begin(), sorted.end());
        const auto [entry, isNew] = known.try_emplace(sorted, int(sheets.triangles.size()));
        if (isNew)
        {
            sheets.triangles.push_back(corners);
            sheets.crossed.emplace_back();
            sheets.source.push_back(soup.source[f]);
        }
        const auto place = std::size_t(entry->second);
        add(sheets.crossed[place], shells.of[std::size_t(soup.source[f])], sheets.triangles[place] == corners ? 1 : -1);
    }
    std::size_t kept = 0; // but facets that a surface passes to and fro
    for (std::size_t f = 0; f < sheets.triangles.size(); ++f)
        if (!sheets.crossed[f].empty())
        {
            sheets.triangles[kept] = sheets.triangles[f];
            sheets.source[kept] = sheets.source[f];
            std::swap(sheets.crossed[kept++], sheets.crossed[f]);
        }
    sheets.triangles.resize(kept);
    sheets.source.resize(kept);
    sheets.crossed.resize(kept);

    DisjointSets patches(kept);
    forEachEdge(sortedHalfEdges(sheets),
                [&](std::span<const HalfEdge> edge)
                {
                    if (edge.size() == 2) patches.join(edge[0].facet, edge[1].facet);
                });
    std::tie(sheets.patch, sheets.patches) = patches.numbered();
    return sheets;
}

struct Sides
{
    Windings front, back;
};

/// The largest coordinate of a normal: lines along it cross the facet best.
int steepest(const Vector<3>& n)
{
    const double x = std::abs(n.x), y = std::abs(n.y), z = std::abs(n.z);
    return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

/// Winding numbers before and behind each patch, counted along a line from a point of its largest facet: exact.
std::vector<Sides> sidesOf(const Sheets& s)
{
    using Exact = CGAL::Exact_predicates_exact_constructions_kernel::FT;
    std::vector<int> largest(std::size_t(s.patches), -1);
    for (int f = 0; f < int(s.triangles.size()); ++f)
    {
        auto& best = largest[std::size_t(s.patch[std::size_t(f)])];
        if (best < 0 || mag(areaVector(s, f)) > mag(areaVector(s, best))) best = f;
    }

    std::vector<Sides> sides(largest.size());
    std::mt19937 random(1);
    std::uniform_real_distribution<double> weight(0.2, 0.4);
    for (int axis = 0; axis < 3; ++axis)
    {
        std::vector<int> patches;
        for (int p = 0; p < s.patches; ++p)
            if (steepest(areaVector(s, largest[std::size_t(p)])) == axis) patches.push_back(p);
        for (int attempt = 0; !patches.empty(); ++attempt)
        {
            // A line that grazes an edge is chance: there is always another.
            if (attempt == 100) throw std::logic_error("removeSelfIntersections: no line crosses a facet");
            std::vector<AxisLine> lines;
            for (const int p : patches)
            {
                const auto& [a, b, c] = s.triangles[std::size_t(largest[std::size_t(p)])];
                const double wa = weight(random), wb = weight(random);
                const auto x = wa * s.points[std::size_t(a)] + wb * s.points[std::size_t(b)] + (1 - wa - wb) * s.points[std::size_t(c)];
                lines.push_back(axis == 0 ? AxisLine{x.y, x.z} : axis == 1 ? AxisLine{x.z, x.x} : AxisLine{x.x, x.y});
            }
            const auto crossings = crossingsOf(s, axis, lines);
            std::vector<Exact> height;
            std::vector<Windings> above(patches.size()); // next to the patch on its upper side
            std::vector<int> upwards(patches.size(), 0);
            for (std::size_t i = 0; i < patches.size(); ++i)
                height.push_back(heightOn<Exact>(s, largest[std::size_t(patches[i])], axis, lines[i]));
            for (const auto& [line, facet, sign] : crossings.all)
            {
                const auto i = std::size_t(line);
                if (facet == largest[std::size_t(patches[i])]) upwards[i] = sign;
                else if (!crossings.grazes[i] && heightOn<Exact>(s, facet, axis, lines[i]) > height[i])
                    for (const auto& [shell, times] : s.crossed[std::size_t(facet)]) add(above[i], shell, sign * times);
            }
            std::vector<int> left;
            for (std::size_t i = 0; i < patches.size(); ++i)
            {
                if (crossings.grazes[i] || upwards[i] == 0)
                {
                    left.push_back(patches[i]);
                    continue;
                }
                auto below = above[i];
                for (const auto& [shell, times] : s.crossed[std::size_t(largest[std::size_t(patches[i])])])
                    add(below, shell, upwards[i] * times);
                auto& side = sides[std::size_t(patches[i])];
                side.front = upwards[i] > 0 ? above[i] : below;
                side.back = upwards[i] > 0 ? below : above[i];
            }
            patches = std::move(left);
        }
    }
    return sides;
}

/// Closed surfaces bound a solid (1) or a cavity (-1). Outermost ones bound solids; one that lies in others bounds what alternates
/// with them, unless it crosses others: then the file says by the orientation of its facets what it is.
std::vector<int> signsOf(const Sheets& s, const std::vector<Sides>& sides, const Shells& shells)
{
    const auto n = std::size_t(shells.count);
    std::vector<std::map<int, int>> patchesIn(n); // of each: patches that lie in others
    std::vector<int> patches(n, 0);
    std::vector<char> seen(sides.size(), 0);
    for (std::size_t f = 0; f < s.triangles.size(); ++f)
    {
        const auto p = std::size_t(s.patch[f]);
        if (seen[p]++) continue;
        for (const auto& [shell, _] : s.crossed[f])
        {
            const bool back = sides[p].back.contains(shell), front = sides[p].front.contains(shell);
            if (back == front) continue; // it lies within itself there
            ++patches[std::size_t(shell)];
            for (const auto& [other, __] : back ? sides[p].back : sides[p].front)
                if (other != shell) ++patchesIn[std::size_t(shell)][other];
        }
    }
    const auto isIn = [&](int inner, int outer)
    {
        const auto found = patchesIn[std::size_t(inner)].find(outer);
        return found != patchesIn[std::size_t(inner)].end() && found->second == patches[std::size_t(inner)];
    };
    std::vector<int> depth(n, 0), outermost(n, -1);
    std::vector<char> crosses(n, 0);
    for (int k = 0; k < shells.count; ++k)
        for (const auto& [other, _] : patchesIn[std::size_t(k)])
        {
            const bool in = isIn(k, other), around = isIn(other, k);
            if (in && !around) ++depth[std::size_t(k)];
            if (!in && !around) crosses[std::size_t(k)] = crosses[std::size_t(other)] = 1;
        }
    for (int k = 0; k < shells.count; ++k)
        for (const auto& [other, _] : patchesIn[std::size_t(k)])
            if (depth[std::size_t(other)] == 0 && isIn(k, other)) outermost[std::size_t(k)] = other;

    std::vector<int> signs(n);
    for (std::size_t k = 0; k < n; ++k)
    {
        const bool asAround = outermost[k] >= 0 && (shells.volume[k] > 0) == (shells.volume[std::size_t(outermost[k])] > 0);
        signs[k] = depth[k] == 0 ? 1 : crosses[k] ? (asAround ? 1 : -1) : (depth[k] % 2 == 0 ? 1 : -1);
    }
    return signs;
}

bool isSolid(const Windings& w, const std::vector<int>& signs)
{
    return std::accumulate(w.begin(), w.end(), 0, [&](int depth, const auto& of) { return depth + signs[std::size_t(of.first)]; }) > 0;
}

/// The volume that a mesh encloses by its winding numbers, whether or not it crosses itself: lengths of lines within it, two lines at random
/// in each cell of a raster across; their differences give the standard error.
EnclosedByLines volumeByLines(const NumberedMesh& m, const Shells& shells, const std::vector<int>& signs)
{
    constexpr int across = 100;
    const auto box = boundingBox(m);
    const auto extent = box.high - box.low;
    const int axis = steepest(extent); // the lines are few and long
    const auto of = [](const Vector<3>& x, int k) { return x.*component(k % 3); };
    const double du = of(extent, axis + 1) / across, dv = of(extent, axis + 2) / across;
    std::mt19937 random(2);
    std::uniform_real_distribution<double> within(0, 1);
    const auto draw = [&](std::size_t i)
    {
        const auto cell = i / 2;
        return AxisLine{of(box.low, axis + 1) + du * (double(cell % across) + within(random)),
                        of(box.low, axis + 2) + dv * (double(cell / across) + within(random))};
    };
    std::vector<AxisLine> lines;
    for (std::size_t i = 0; i < 2u * across * across; ++i) lines.push_back(draw(i));
    auto crossings = crossingsOf(m, axis, lines);
    while (std::any_of(crossings.grazes.begin(), crossings.grazes.end(), [](char g) { return g; }))
    {
        for (std::size_t i = 0; i < lines.size(); ++i)
            if (crossings.grazes[i]) lines[i] = draw(i);
        crossings = crossingsOf(m, axis, lines);
    }

    std::vector<std::vector<std::pair<double, Crossing>>> along(lines.size());
    for (const auto& c : crossings.all)
        along[std::size_t(c.line)].emplace_back(heightOn<double>(m, c.facet, axis, lines[std::size_t(c.line)]), c);
    std::vector<double> length(lines.size(), 0);
    for (std::size_t i = 0; i < lines.size(); ++i)
    {
        std::sort(along[i].begin(), along[i].end(),
                  [](const auto& a, const auto& b) { return a.first != b.first ? a.first < b.first : a.second.facet < b.second.facet; });
        Windings w;
        double entered = 0;
        for (const auto& [height, c] : along[i])
        {
            const bool before = isSolid(w, signs);
            add(w, shells.of[std::size_t(c.facet)], -c.sign);
            const bool after = isSolid(w, signs);
            if (!before && after) entered = height;
            if (before && !after) length[i] += height - entered;
        }
    }
    EnclosedByLines result;
    result.lines = lines.size();
    double variance = 0;
    for (std::size_t i = 0; i < lines.size(); i += 2)
    {
        result.volume += 0.5 * (length[i] + length[i + 1]) * du * dv;
        variance += sqr(0.5 * (length[i] - length[i + 1]) * du * dv);
    }
    result.error = std::sqrt(variance);
    return result;
}

}

void checkNothingIsLost(const NumberedMesh& repaired, const NumberedMesh& m, const EnclosedByLines& enclosed, double tolerance)
{
    const auto was = boundingBox(m), is = boundingBox(repaired);
    const char* names[] = {"x", "y", "z"};
    std::string lost;
    for (int k = 0; k < 3; ++k)
    {
        const auto c = component(k);
        const double less = (was.high.*c - was.low.*c) - (is.high.*c - is.low.*c);
        if (std::abs(less) > 2 * tolerance)
            lost += fmt::format("\n    {:.4g} m of its {:.4g} m along {}", less, was.high.*c - was.low.*c, names[k]);
    }
    constexpr double standardErrors = 6;
    double area = 0;
    for (std::size_t f = 0; f < m.triangles.size(); ++f) area += 0.5 * mag(areaVector(m, int(f)));
    const double volume = enclosedVolume(repaired), less = enclosed.volume - volume;
    if (std::abs(less) > standardErrors * enclosed.error + tolerance * area)
        lost += fmt::format("\n    {:.4g} m3 of the {:.4g} +- {:.1g} m3 that it winds around", less, enclosed.volume, enclosed.error);
    if (!lost.empty())
        throw UnusableMesh("the surface crosses itself and cannot be repaired without a loss. The repair would take" + lost +
                           "\nRepair it where it was made, or wrap it: wrap { tolerance ...; }");
}

double removeSelfIntersections(NumberedMesh& m, double tolerance, std::vector<std::string>& repairs)
{
    FacetSoup soup(m, tolerance);
    auto meetings = findMeetings(soup);
    if (meetings.pairs.empty()) return tolerance;
    const auto shells = findShells(m);
    std::size_t between = 0, within = 0;
    for (const auto& [f, g] : meetings.pairs)
    {
        const int a = shells.of[std::size_t(soup.source[std::size_t(f)])], b = shells.of[std::size_t(soup.source[std::size_t(g)])];
        ++(a == b ? within : between);
    }

    bool split = splitWhereFacetsMeet(soup, std::move(meetings));
    // Splits of features as small as the tolerance may go round in circles; a smaller tolerance takes them for what they are.
    double apart = tolerance;
    while (!split && apart > 1e-5 * tolerance)
    {
        apart *= 0.01;
        soup = FacetSoup(m, apart);
        split = splitWhereFacetsMeet(soup, findMeetings(soup));
    }
    if (!split) checkSelfIntersections(m, tolerance, "They cannot be parted exactly. Wrap the mesh: wrap { tolerance ...; }");
    const auto sheets = sheetsOf(soup, shells);
    if (sheets.triangles.empty()) throw UnusableMesh("no facet is left: the surface has no volume, each facet has its opposite");
    const auto sides = sidesOf(sheets);
    const auto signs = signsOf(sheets, sides, shells);
    NumberedMesh result;
    result.regions = m.regions;
    result.points = sheets.points;
    for (std::size_t f = 0; f < sheets.triangles.size(); ++f)
    {
        const auto& [front, back] = sides[std::size_t(sheets.patch[f])];
        const bool solidInFront = isSolid(front, signs), solidBehind = isSolid(back, signs);
        if (solidInFront == solidBehind) continue;
        auto corners = sheets.triangles[f];
        if (solidInFront) std::swap(corners[1], corners[2]);
        result.triangles.push_back(corners);
        result.region.push_back(m.region[std::size_t(sheets.source[f])]);
        result.number.push_back(m.number[std::size_t(sheets.source[f])]);
    }
    removeUnusedPoints(result);
    const auto enclosed = volumeByLines(m, shells, signs);
    checkNothingIsLost(result, m, enclosed, tolerance);
    std::vector<std::string> parted;
    splitEdges(result);
    splitPoints(result, parted);

    const int left = findShells(result).count;
    if (between > 0)
        repairs.push_back(fmt::format("{} that cross or touch in {} of facets united to {}",
                                      counted(std::size_t(shells.count), "closed surface"), counted(between, "pair"), left));
    if (within > 0)
        repairs.push_back(fmt::format("{} of facets of one surface that cross: replaced by the outside of all that it winds around",
                                      counted(within, "pair")));
    repairs.push_back(fmt::format("the solid is now {:.6g} m3; along {} lines the mesh as it was winds around {:.6g} +- {:.1g} m3",
                                  enclosedVolume(result), enclosed.lines, enclosed.volume, enclosed.error));
    m = std::move(result);
    if (apart < tolerance) // what the first tolerance would have drawn together
    {
        auto even = m;
        std::vector<std::string> removed;
        removeSlivers(even, tolerance, removed);
        if (FacetSoup parts(even, apart); findMeetings(parts).pairs.empty())
        {
            m = std::move(even);
            repairs.insert(repairs.end(), removed.begin(), removed.end());
        }
    }
    return apart;
}

}
