#include "solids/meshDistance.hpp"
#include <algorithm>

namespace sph
{

double distanceToTriangle(const Vector<3>& p, const Vector<3>& a, const Vector<3>& b, const Vector<3>& c)
{
    const auto ab = b - a, ac = c - a, n = cross(ab, ac);
    const auto beside = [&](const Vector<3>& from, const Vector<3>& to) { return dot(cross(n, to - from), p - from) < 0; };
    const bool isOverFace = !beside(a, b) && !beside(b, c) && !beside(c, a);
    if (isOverFace && dot(n, n) > 0) return std::abs(dot(p - a, n)) / mag(n);
    const auto toEdge = [&](const Vector<3>& from, const Vector<3>& to)
    {
        const auto e = to - from;
        const double t = std::clamp(dot(p - from, e) / dot(e, e), 0.0, 1.0);
        return mag(p - (from + t * e));
    };
    return std::min({toEdge(a, b), toEdge(b, c), toEdge(c, a)});
}

double distanceToSurface(const TriangleSurface& s, const Vector<3>& p)
{
    double least = Box::infinity;
    for (const auto& [a, b, c] : s.triangles)
        least = std::min(least, distanceToTriangle(p, s.points[std::size_t(a)], s.points[std::size_t(b)], s.points[std::size_t(c)]));
    return least;
}

bool isInside(const TriangleSurface& s, const Vector<3>& p)
{
    bool inside = false;
    for (const auto& t : s.triangles)
    {
        // Each edge is looked at from its lower point, so that two facets agree on which of them the line through p meets.
        bool meets = false;
        for (std::size_t k = 0; k < 3; ++k)
        {
            const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
            const auto &u = s.points[std::size_t(low)], &v = s.points[std::size_t(high)];
            if ((u.y > p.y) != (v.y > p.y) && p.x < u.x + (p.y - u.y) / (v.y - u.y) * (v.x - u.x)) meets = !meets;
        }
        if (!meets) continue;
        const auto& a = s.points[std::size_t(t[0])];
        const auto n = cross(s.points[std::size_t(t[1])] - a, s.points[std::size_t(t[2])] - a);
        // The plane of the facet above p
        if (dot(a - p, n) / n.z > 0) inside = !inside;
    }
    return inside;
}

namespace
{

Box boundsOf(const TriangleSurface& s)
{
    Box b{s.points.front(), s.points.front()};
    for (const auto& p : s.points)
    {
        b.low = {std::min(b.low.x, p.x), std::min(b.low.y, p.y), std::min(b.low.z, p.z)};
        b.high = {std::max(b.high.x, p.x), std::max(b.high.y, p.y), std::max(b.high.z, p.z)};
    }
    return b;
}

struct PlacedSolid
{
    TriangleSurface surface;
    Box bounds;
};

Box common(const Box& a, const Box& b)
{
    return {{std::max(a.low.x, b.low.x), std::max(a.low.y, b.low.y), std::max(a.low.z, b.low.z)},
            {std::min(a.high.x, b.high.x), std::min(a.high.y, b.high.y), std::min(a.high.z, b.high.z)}};
}

bool isEmpty(const Box& b) { return b.low.x > b.high.x || b.low.y > b.high.y || b.low.z > b.high.z; }

/// Point at which the segment p + t (q - p) goes through the triangle, if it does.
std::optional<double> crossing(const Vector<3>& p, const Vector<3>& q, const Vector<3>& a, const Vector<3>& b, const Vector<3>& c)
{
    const auto d = q - p, u = b - a, v = c - a, h = cross(d, v);
    const double det = dot(u, h);
    if (det == 0) return {};
    const auto s = p - a, w = cross(s, u);
    const double beta = dot(s, h) / det, gamma = dot(d, w) / det, t = dot(v, w) / det;
    if (beta < 0 || gamma < 0 || beta + gamma > 1 || t < 0 || t > 1) return {};
    return t;
}

/// Deepest point of the edges of a below the surface of b, and whether any crosses it.
double edgesWithin(const PlacedSolid& a, const PlacedSolid& b, const Box& both, bool& crosses)
{
    const auto within = [&](std::initializer_list<Vector<3>> points)
    {
        Box box{*points.begin(), *points.begin()};
        for (const auto& p : points)
        {
            box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y), std::min(box.low.z, p.z)};
            box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y), std::max(box.high.z, p.z)};
        }
        return !isEmpty(common(box, both));
    };
    const auto& s = b.surface;
    const auto at = [&](int i) { return s.points[std::size_t(i)]; };
    std::vector<std::array<int, 3>> facets;
    for (const auto& t : s.triangles)
        if (within({at(t[0]), at(t[1]), at(t[2])})) facets.push_back(t);
    double deepest = 0;
    std::vector<double> cuts;
    for (const auto& t : a.surface.triangles)
        for (std::size_t k = 0; k < 3; ++k)
        {
            if (t[k] > t[(k + 1) % 3]) continue; // once from one side
            const auto &p = a.surface.points[std::size_t(t[k])], &q = a.surface.points[std::size_t(t[(k + 1) % 3])];
            if (!within({p, q})) continue;
            cuts = {0, 1};
            for (const auto& f : facets)
                if (const auto cut = crossing(p, q, at(f[0]), at(f[1]), at(f[2]))) cuts.push_back(*cut);
            crosses = crosses || cuts.size() > 2;
            std::ranges::sort(cuts);
            for (std::size_t m = 1; m < cuts.size(); ++m)
            {
                if (!isInside(s, p + 0.5 * (cuts[m - 1] + cuts[m]) * (q - p))) continue;
                constexpr int samples = 8;
                for (int l = 0; l <= samples; ++l)
                {
                    const double at_l = cuts[m - 1] + (cuts[m] - cuts[m - 1]) * l / samples;
                    deepest = std::max(deepest, distanceToSurface(s, p + at_l * (q - p)));
                }
            }
        }
    return deepest;
}

double meshes(const PlacedSolid& a, const PlacedSolid& b)
{
    const auto both = common(a.bounds, b.bounds);
    if (isEmpty(both)) return 0;
    bool crosses = false;
    const double depth = std::max(edgesWithin(a, b, both, crosses), edgesWithin(b, a, both, crosses));
    // Edges that cross without a point of them inside: too little to be seen, not to be there.
    return crosses ? std::max(depth, 1e-12 * mag(a.bounds.high - a.bounds.low)) : depth;
}

PlacedSolid shifted(PlacedSolid solid, const Vector<3>& by)
{
    for (auto& p : solid.surface.points) p = p + by;
    solid.bounds = {solid.bounds.low + by, solid.bounds.high + by};
    return solid;
}

double meshAndSphere(const PlacedSolid& a, const Vector<3>& centre, double radius)
{
    const double distance = distanceToSurface(a.surface, centre);
    return std::max(0.0, isInside(a.surface, centre) ? radius + distance : radius - distance);
}

/// Distance by which points beyond `radius` about them reach out of the container, whose top is open unless solids repeat there.
double outside(const SolidContainer& c, std::span<const Vector<3>> points, double radius)
{
    double most = 0;
    for (const auto& p : points)
    {
        if (!c.periodic[2]) most = std::max(most, radius - p.z);
        if (c.isCylinder) most = std::max(most, std::hypot(p.x, p.y) + radius - c.radius);
        if (!c.isCylinder && !c.periodic[0]) most = std::max({most, radius - p.x, p.x + radius - c.length});
        if (!c.isCylinder && !c.periodic[1]) most = std::max({most, radius - p.y, p.y + radius - c.width});
    }
    return most;
}

}

std::vector<Overlap> findOverlaps(const SolidContainer& c, const Bed& bed)
{
    std::vector<PlacedSolid> solids(bed.bodies.size());
    std::vector<Vector<3>> centres;
    std::vector<double> reach;
    std::vector<Overlap> overlaps;
    const auto note = [&](int i, int j, double depth)
    {
        if (depth > 0) overlaps.push_back({i, j, depth});
    };
    constexpr int container = -1;
    for (std::size_t i = 0; i < solids.size(); ++i)
    {
        const auto& b = bed.bodies[i];
        centres.push_back(b.centre);
        reach.push_back(bed.reachOf(b));
        if (bed.shapeOf(b).isSphere())
        {
            note(int(i), container, outside(c, {&b.centre, 1}, 0.5 * b.size));
            continue;
        }
        solids[i].surface = bed.shapeOf(b).mesh;
        for (auto& p : solids[i].surface.points) p = b.centre + b.size * b.rotation(p);
        solids[i].bounds = boundsOf(solids[i].surface);
        note(int(i), container, outside(c, solids[i].surface.points, 0));
    }
    for (const auto& [i, j] : nearPairs(c, centres, reach, 0))
    {
        const auto a = std::size_t(i), b = std::size_t(j);
        const bool round = bed.shapeOf(bed.bodies[a]).isSphere(), otherRound = bed.shapeOf(bed.bodies[b]).isSphere();
        const auto apart = shortest(c, centres[b] - centres[a]);
        const auto shift = apart - (centres[b] - centres[a]); // of b, to the nearest of its copies
        if (round && otherRound) note(i, j, reach[a] + reach[b] - mag(apart));
        else if (round) note(i, j, meshAndSphere(solids[b], centres[a] - shift, reach[a]));
        else if (otherRound) note(i, j, meshAndSphere(solids[a], centres[b] + shift, reach[b]));
        else note(i, j, meshes(solids[a], shift == Vector<3>{} ? solids[b] : shifted(solids[b], shift)));
    }
    return overlaps;
}

double deepest(const std::vector<Overlap>& overlaps)
{
    double most = 0;
    for (const auto& o : overlaps) most = std::max(most, o.depth);
    return most;
}

double largestOverlap(const SolidContainer& c, const Bed& bed) { return deepest(findOverlaps(c, bed)); }

}
