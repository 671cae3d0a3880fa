#include "meshes/continuePeriodically.hpp"
#include "base/words.hpp"
#include "geometry/components.hpp"
#include "meshes/WeldedPoints.hpp"
#include "meshes/cleanSoup.hpp"
#include "meshes/orientShells.hpp"
#include "meshes/readers/Polygons.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <set>
#include <unordered_map>

namespace sph
{

namespace
{

using Line = std::array<int, 2>; ///< an edge of one facet alone, by its points, the lower first

/// A mesh and what its facets are copies of.
struct Copies
{
    NumberedMesh& m;
    std::vector<int> original;  ///< facet of the mesh before
    std::vector<char> isCapped; ///< of the facets before: those that lay in a face and are gone

    explicit Copies(NumberedMesh& mesh) : m(mesh), original(mesh.triangles.size()), isCapped(mesh.triangles.size(), 0)
    {
        for (std::size_t f = 0; f < original.size(); ++f) original[f] = int(f);
    }
};

/// The two faces of a direction, and the lines that the mesh ends in there.
struct Cut
{
    int direction;
    double low, high;           ///< coordinates of the faces
    std::vector<char> isCap;    ///< of each facet
    std::vector<Line> lines[2]; ///< in the low and the high face
    std::vector<int> mate;      ///< of each point of a line in the high face, the one of the low face; -1 of all others
    double misfit = 0;          ///< largest distance of mates [m]

    bool isThere() const { return !lines[0].empty() && !lines[1].empty(); }
};

Cut findCut(const NumberedMesh& m, const MeshSpace& space, int direction, double tolerance)
{
    const auto c = component(direction);
    Cut cut{direction, space.low.*c, space.high.*c, {}, {}, {}};
    std::vector<char> face; // of each point: 0 in none, 1 in the low one, 2 in the high one
    for (const auto& x : m.points)
        face.push_back(std::abs(x.*c - cut.low) <= tolerance ? 1 : std::abs(x.*c - cut.high) <= tolerance ? 2 : 0);
    const auto faceOf = [&](int p) { return face[std::size_t(p)]; };
    for (const auto& [p, q, r] : m.triangles) cut.isCap.push_back(faceOf(p) > 0 && faceOf(p) == faceOf(q) && faceOf(p) == faceOf(r));
    forEachEdge(sortedHalfEdges(m),
                [&](std::span<const HalfEdge> edge)
                {
                    const int of = faceOf(edge[0].low);
                    if (of == 0 || of != faceOf(edge[0].high)) return;
                    const auto facets = std::ranges::count_if(edge, [&](const HalfEdge& h) { return !cut.isCap[std::size_t(h.facet)]; });
                    if (facets == 1) cut.lines[of - 1].push_back({edge[0].low, edge[0].high});
                });
    return cut;
}

/// "x = 0.1 m"
std::string inWords(const Cut& cut, int face)
{
    return fmt::format("{} = {:.6g} m", coordinateNames[cut.direction], face == 0 ? cut.low : cut.high);
}

[[noreturn]] void failToMatch(const NumberedMesh& m, const Cut& cut, int face, const std::vector<int>& alone, double tolerance)
{
    const auto c = component(cut.direction);
    std::set<int> others;
    for (const auto& line : cut.lines[1 - face]) others.insert(line.begin(), line.end());
    double misfit = 0;
    int worst = alone.front();
    for (const int p : alone)
    {
        auto place = m.points[std::size_t(p)];
        place.*c += face == 0 ? cut.high - cut.low : cut.low - cut.high;
        double nearest = std::numeric_limits<double>::infinity();
        for (const int q : others) nearest = std::min(nearest, mag(place - m.points[std::size_t(q)]));
        if (nearest > misfit)
        {
            misfit = nearest;
            worst = p;
        }
    }
    throw UnusableMesh(fmt::format(
        "the mesh is cut at the periodic faces {} and {}, and the cuts do not match: {} of the first {} no point of the other within {:.3g} m, the "
        "farthest, {}, is {:.3g} m from the nearest. Cut it at places one period apart whose facets are alike; or say in `weld` how far points may be apart",
        inWords(cut, face), inWords(cut, 1 - face), counted(alone.size(), "point"), alone.size() == 1 ? "has" : "have", tolerance,
        inWords(m.points[std::size_t(worst)]), misfit));
}

/// Finds the mates. Throws where a point or a line has none.
void match(const NumberedMesh& m, Cut& cut, double tolerance)
{
    const auto c = component(cut.direction);
    std::set<int> points[2];
    for (const int face : {0, 1})
        for (const auto& line : cut.lines[face]) points[face].insert(line.begin(), line.end());
    WeldedPoints places(tolerance, boundingBox(m));
    std::vector<int> low;
    for (const int p : points[0])
        if (places.add(m.points[std::size_t(p)]) == int(low.size()))
            low.push_back(p); // one nearer to another than the tolerance stays alone
    cut.mate.assign(m.points.size(), -1);
    std::set<int> free = points[0];
    std::vector<int> alone;
    for (const int p : points[1])
    {
        auto place = m.points[std::size_t(p)];
        place.*c -= cut.high - cut.low;
        const int found = places.add(place);
        const int mate = found < int(low.size()) ? low[std::size_t(found)] : -1;
        if (mate < 0 || free.erase(mate) == 0)
        {
            alone.push_back(p);
            continue;
        }
        cut.mate[std::size_t(p)] = mate;
        cut.misfit = std::max(cut.misfit, mag(place - m.points[std::size_t(mate)]));
    }
    if (!alone.empty()) failToMatch(m, cut, 1, alone, tolerance);
    if (!free.empty()) failToMatch(m, cut, 0, {free.begin(), free.end()}, tolerance);
    const std::set<Line> lowLines(cut.lines[0].begin(), cut.lines[0].end());
    std::set<Line> highLines;
    for (const auto& [p, q] : cut.lines[1])
    {
        const auto [a, b] = std::minmax(cut.mate[std::size_t(p)], cut.mate[std::size_t(q)]);
        highLines.insert({a, b});
    }
    std::vector<Line> single; // in the low face, or where it would be
    std::ranges::set_symmetric_difference(lowLines, highLines, std::back_inserter(single));
    if (!single.empty())
        throw UnusableMesh(fmt::format(
            "the mesh is cut at the periodic faces {} and {}, whose points match, but not the lines between them: that from {} to {} is there in one of them alone",
            inWords(cut, 0), inWords(cut, 1), inWords(m.points[std::size_t(single[0][0])]), inWords(m.points[std::size_t(single[0][1])])));
}

/// Replaces the mesh by 2n + 1 of its periods, joined where it was cut.
void join(Copies& copies, const Cut& cut, int n)
{
    auto& m = copies.m;
    const auto c = component(cut.direction);
    const double period = cut.high - cut.low;
    const auto before = m;
    const auto originals = copies.original;
    std::vector<std::vector<int>> place(std::size_t(2 * n + 1), std::vector<int>(before.points.size()));
    m.points.clear();
    for (int k = 2 * n; k >= 0; --k) // the mates of a copy are those of the next
        for (std::size_t p = 0; p < before.points.size(); ++p)
        {
            auto& at = place[std::size_t(k)][p];
            if (cut.mate[p] >= 0 && k < 2 * n)
            {
                at = place[std::size_t(k) + 1][std::size_t(cut.mate[p])];
                continue;
            }
            at = int(m.points.size());
            auto x = before.points[p];
            if (cut.mate[p] >= 0)
            {
                x = before.points[std::size_t(cut.mate[p])];
                x.*c += period;
            }
            x.*c += (k - n) * period;
            m.points.push_back(x);
        }
    m.triangles.clear();
    m.region.clear();
    m.number.clear();
    copies.original.clear();
    for (const auto& points : place)
        for (std::size_t f = 0; f < before.triangles.size(); ++f)
        {
            if (cut.isCap[f])
            {
                copies.isCapped[std::size_t(originals[f])] = 1;
                continue;
            }
            auto corners = before.triangles[f];
            for (int& corner : corners) corner = points[std::size_t(corner)];
            m.triangles.push_back(corners);
            m.region.push_back(before.region[f]);
            m.number.push_back(before.number[f]);
            copies.original.push_back(originals[f]);
        }
    removeUnusedPoints(m);
}

/// A direction in which periods have been joined, and the coordinates at which they end.
struct Span
{
    int direction;
    double low, high;   ///< of the domain
    double first, last; ///< of the periods
    double tolerance;
    bool ends(const NumberedMesh& m, const HalfEdge& h) const
    {
        const auto c = component(direction);
        const auto at = [&](int p, double end) { return std::abs(m.points[std::size_t(p)].*c - end) <= tolerance; };
        return (at(h.low, first) && at(h.high, first)) || (at(h.low, last) && at(h.high, last));
    }
};

/// The parts of the joined periods: bodies, pieces of such at the ends, and what goes on through.
class Parts
{
    const Copies& copies_;
    const std::vector<Span>& spans_;
    Shells shells_;
    std::vector<char> goesOn_;                               ///< holds a facet and its copy
    std::vector<std::map<int, std::vector<HalfEdge>>> ends_; ///< of each part, its lines where the periods end, by direction

    bool isInDomain(const Box& box) const
    {
        return std::ranges::all_of(spans_,
                                   [&](const Span& s)
                                   {
                                       const auto c = component(s.direction);
                                       const double middle = 0.5 * (box.low.*c + box.high.*c), rounding = 1e-9 * (s.high - s.low);
                                       return middle >= s.low - rounding && middle < s.high - rounding;
                                   });
    }
    bool isWhole(int part) const { return ends_[std::size_t(part)].empty(); }
    /// The part that a cavity goes with: the whole one, of the largest box, that has its box in its own; itself where there is none.
    int bodyOf(int part, const std::vector<int>& byLength) const
    {
        const auto& box = shells_.box[std::size_t(part)];
        for (const int other : byLength)
        {
            const auto& around = shells_.box[std::size_t(other)];
            if (std::ranges::all_of(coordinates, [&](auto c) { return around.low.*c <= box.low.*c && around.high.*c >= box.high.*c; }))
                return other;
        }
        return part;
    }

public:
    std::size_t bodies = 0, through = 0;

    Parts(const Copies& copies, const std::vector<Span>& spans)
        : copies_(copies),
          spans_(spans),
          shells_(findShells(copies.m)),
          goesOn_(std::size_t(shells_.count), 0),
          ends_(std::size_t(shells_.count))
    {
        const auto& m = copies.m;
        std::set<std::pair<int, int>> seen;
        for (std::size_t f = 0; f < m.triangles.size(); ++f)
            if (!seen.emplace(shells_.of[f], copies.original[f]).second) goesOn_[std::size_t(shells_.of[f])] = 1;
        forEachEdge(sortedHalfEdges(m),
                    [&](std::span<const HalfEdge> edge)
                    {
                        if (edge.size() != 1) return;
                        for (const auto& s : spans)
                            if (s.ends(m, edge[0]))
                                ends_[std::size_t(shells_.of[std::size_t(edge[0].facet)])][s.direction].push_back(edge[0]);
                    });
    }

    /// Facets that stay: bodies once, in the domain by their middle, and what goes on through.
    std::vector<char> kept()
    {
        std::vector<int> byLength;
        for (int part = 0; part < shells_.count; ++part)
            if (isWhole(part)) byLength.push_back(part);
        const auto lengthOf = [&](int part) { return mag(shells_.box[std::size_t(part)].high - shells_.box[std::size_t(part)].low); };
        std::ranges::stable_sort(byLength, [&](int a, int b) { return lengthOf(a) > lengthOf(b); });
        std::vector<char> stays(std::size_t(shells_.count), 0);
        for (int part = 0; part < shells_.count; ++part)
        {
            auto& is = stays[std::size_t(part)];
            if (goesOn_[std::size_t(part)]) is = 1;
            else if (isWhole(part)) is = isInDomain(shells_.box[std::size_t(bodyOf(part, byLength))]);
            bodies += is && !goesOn_[std::size_t(part)];
            through += is && goesOn_[std::size_t(part)];
        }
        // A facet of a body is to be there once.
        std::vector<char> keep;
        std::vector<int> times(copies_.isCapped.begin(), copies_.isCapped.end());
        for (std::size_t f = 0; f < copies_.m.triangles.size(); ++f)
        {
            const auto part = std::size_t(shells_.of[f]);
            keep.push_back(stays[part]);
            auto& n = times[std::size_t(copies_.original[f])];
            if (stays[part]) n = goesOn_[part] ? 1 : n + 1;
        }
        if (!std::ranges::all_of(times, [](int n) { return n == 1; }))
            throw UnusableMesh(
                "the mesh is cut at periodic faces, and a body that they cut is longer than the periods that were joined: is the domain that of the mesh?");
        return keep;
    }
    /// Lines in which what goes on through ends, and the direction. Throws where one part does so in two.
    std::map<int, std::vector<HalfEdge>> openEnds() const
    {
        std::map<int, std::vector<HalfEdge>> all;
        for (int part = 0; part < shells_.count; ++part)
        {
            if (!goesOn_[std::size_t(part)]) continue;
            const auto& ends = ends_[std::size_t(part)];
            if (ends.size() > 1)
                throw UnusableMesh(fmt::format(
                    "one part of the mesh goes on through the periodic faces of {} and {}: that is possible in one direction alone. Part it into bodies, or give "
                    "walls to the other direction",
                    coordinateNames[ends.begin()->first], coordinateNames[std::next(ends.begin())->first]));
            for (const auto& [direction, lines] : ends) all[direction].insert(all[direction].end(), lines.begin(), lines.end());
        }
        return all;
    }
};

/// Closed lines of edges, by their points.
std::vector<std::vector<int>> chained(const NumberedMesh& m, const std::vector<HalfEdge>& edges)
{
    std::unordered_map<int, std::vector<int>> next;
    for (const auto& e : edges)
    {
        next[e.low].push_back(e.high);
        next[e.high].push_back(e.low);
    }
    for (const auto& [p, ways] : next)
        if (ways.size() != 2)
            throw UnusableMesh(fmt::format(
                "the mesh is cut at a periodic face in a line that is not closed, or that touches itself: at {}, or a period off, {} of its edges meet",
                inWords(m.points[std::size_t(p)]), ways.size()));
    std::vector<std::vector<int>> loops;
    std::set<int> done;
    for (const auto& e : edges)
    {
        if (done.contains(e.low)) continue;
        std::vector<int> loop{e.low};
        for (int last = e.low, at = e.high; at != e.low;)
        {
            loop.push_back(at);
            const auto& ways = next.at(at);
            const int on = ways[0] == last ? ways[1] : ways[0];
            last = at;
            at = on;
        }
        done.insert(loop.begin(), loop.end());
        loops.push_back(std::move(loop));
    }
    return loops;
}

/// Closes an end of what goes on through, each line by a tube and a lid: one around others farther out than they, so that none lies in another.
void closeEnd(NumberedMesh& m, const Span& span, bool isLast, const std::vector<HalfEdge>& edges)
{
    const auto c = component(span.direction);
    std::unordered_map<int, int> regionAt;
    for (const auto& e : edges)
        for (const int p : {e.low, e.high}) regionAt[p] = m.region[std::size_t(e.facet)];
    auto loops = chained(m, edges);
    const auto areaOf = [&](const std::vector<int>& loop)
    {
        const auto x = [&](std::size_t k) { return m.points[std::size_t(loop[k])]; };
        Vector<3> area;
        for (std::size_t k = 1; k + 1 < loop.size(); ++k) area += cross(x(k) - x(0), x(k + 1) - x(0));
        return mag(area);
    };
    std::ranges::stable_sort(loops, {}, areaOf);
    for (std::size_t l = 0; l < loops.size(); ++l)
    {
        const auto& loop = loops[l];
        const int region = regionAt.at(loop[0]), first = int(m.points.size()), count = int(loop.size());
        const auto add = [&](const std::array<int, 3>& corners)
        {
            m.triangles.push_back(corners);
            m.region.push_back(region);
            m.number.push_back(-1);
        };
        const double length = (span.high - span.low) * double(l + 1) / double(loops.size());
        std::vector<Vector<3>> lid;
        for (const int p : loop)
        {
            lid.push_back(m.points[std::size_t(p)]);
            lid.back().*c += isLast ? length : -length;
        }
        m.points.insert(m.points.end(), lid.begin(), lid.end());
        for (int k = 0; k < count; ++k)
        {
            const int next = (k + 1) % count;
            add({loop[std::size_t(k)], loop[std::size_t(next)], first + next});
            add({loop[std::size_t(k)], first + next, first + k});
        }
        for (const auto& t : triangulate(lid)) add({first + t[0], first + t[1], first + t[2]});
    }
}

}

void continuePeriodically(NumberedMesh& m, const MeshSpace& space, double tolerance, std::vector<std::string>& repairs)
{
    Copies copies(m);
    std::vector<Span> spans;
    double misfit = 0;
    std::size_t lines = 0;
    const double within = std::max(tolerance, 1e-3 * space.spacing);
    for (int k = 0; k < 3; ++k)
    {
        if (!space.periodic[std::size_t(k)]) continue;
        auto cut = findCut(m, space, k, within);
        if (!cut.isThere()) continue;
        match(m, cut, within);
        const double period = cut.high - cut.low;
        const int n = std::max(1, int(std::ceil(4 * space.H / period)));
        lines += cut.lines[0].size();
        misfit = std::max(misfit, cut.misfit);
        join(copies, cut, n);
        spans.push_back({k, cut.low, cut.high, cut.low - n * period, cut.high + n * period, within});
    }
    if (spans.empty()) return;

    Parts parts(copies, spans);
    const auto keep = parts.kept();
    const auto ends = parts.openEnds();
    for (const auto& span : spans)
        if (const auto found = ends.find(span.direction); found != ends.end())
            for (const bool isLast : {false, true})
            {
                const auto isThere = [&](const HalfEdge& h)
                { return (m.points[std::size_t(h.low)].*component(span.direction) > span.high) == isLast; };
                std::vector<HalfEdge> ofEnd;
                std::ranges::copy_if(found->second, std::back_inserter(ofEnd), isThere);
                closeEnd(m, span, isLast, ofEnd);
            }
    dropFacets(m, [&](std::size_t f) { return f >= keep.size() || keep[f]; }); // what closes ends stays
    removeUnusedPoints(m);

    std::string directions;
    for (const auto& span : spans) directions += (directions.empty() ? "" : ", ") + std::string(1, coordinateNames[span.direction]);
    repairs.push_back(fmt::format("joined where the periodic faces of {} cut it, in {} that match within {:.2g} m: {}{}{}", directions,
                                  counted(lines, "edge"), misfit, parts.bodies > 0 ? counted(parts.bodies, "closed surface") : "",
                                  parts.bodies > 0 && parts.through > 0 ? ", and " : "",
                                  parts.through > 0
                                      ? fmt::format("{} through the domain and is closed beyond it",
                                                    parts.through == 1 ? "one goes on" : fmt::format("{} go on", parts.through))
                                      : ""));
}

}
