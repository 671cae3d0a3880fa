#include "meshes/FacetSoup.hpp"
#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>
#include <algorithm>
#include <cmath>
#include <limits>

namespace sph
{

namespace
{

/// A point that two facets have in common, and the edges of each on which it lies, as bits.
struct Common
{
    int point;
    unsigned onFirst, onSecond;
};

/// A point nearer to an edge or a facet than this share of the distance at which points are one lies on it. Were it 1, each corner of a
/// triangle that is hardly larger than that distance would lie on the edge across, and splits would have no end.
constexpr double nearness = 0.5;

/// The edges of a corner: k, which leaves it, and the one before.
constexpr unsigned edgesOfCorner(std::size_t k) { return 1u << k | 1u << (k + 2) % 3; }

bool contains(const std::array<int, 3>& facet, int point) { return std::find(facet.begin(), facet.end(), point) != facet.end(); }

class Search
{
    FacetSoup& s_;
    Meetings& found_;
    const double tolerance_;
    std::vector<Common> common_; ///< of the two facets looked at

    const Vector<3>& at(int point) const { return s_.points[point]; }
    const std::array<int, 3>& corners(int facet) const { return s_.facets[std::size_t(facet)]; }
    EdgeKey edge(int facet, std::size_t k) const
    {
        const int a = corners(facet)[k], b = corners(facet)[(k + 1) % 3];
        return {std::min(a, b), std::max(a, b)};
    }

    /// Position along the segment, 0 to 1 between its ends.
    double along(const Vector<3>& x, const EdgeKey& e) const
    {
        const auto d = at(e[1]) - at(e[0]);
        return dot(x - at(e[0]), d) / dot(d, d);
    }
    double distanceToLine(const Vector<3>& x, const EdgeKey& e) const { return mag(x - at(e[0]) - along(x, e) * (at(e[1]) - at(e[0]))); }
    /// Whether a point lies beside the segment within the tolerance, its ends excluded.
    bool isOn(int point, const EdgeKey& e) const
    {
        const double t = along(at(point), e);
        return t > 0 && t < 1 && distanceToLine(at(point), e) <= tolerance_;
    }

    void putOnEdge(const EdgeKey& e, int point)
    {
        if (point == e[0] || point == e[1]) return;
        if (const double t = along(at(point), e); t > 0 && t < 1) found_.onEdge[e].insert(point);
    }

    void note(int point, unsigned onFirst, unsigned onSecond)
    {
        const auto known = std::find_if(common_.begin(), common_.end(), [&](const Common& c) { return c.point == point; });
        if (known == common_.end()) common_.push_back({point, onFirst, onSecond});
        else
        {
            known->onFirst |= onFirst;
            known->onSecond |= onSecond;
        }
    }
    void note(int point, unsigned onFirst, unsigned onSecond, bool swapped)
    {
        swapped ? note(point, onSecond, onFirst) : note(point, onFirst, onSecond);
    }

    /// A corner of g on an edge of f, or in f.
    void cornerMeets(int f, int g, std::size_t corner, bool swapped)
    {
        const int point = corners(g)[corner];
        const auto& x = at(point);
        const auto &a = at(corners(f)[0]), &b = at(corners(f)[1]), &c = at(corners(f)[2]);
        const auto n = unitVector(cross(b - a, c - a));
        const double height = dot(x - a, n);
        if (std::abs(height) > tolerance_) return;
        double least = std::numeric_limits<double>::infinity();
        std::size_t nearest = 0;
        for (std::size_t k = 0; k < 3; ++k)
        {
            const auto &p = at(corners(f)[k]), &q = at(corners(f)[(k + 1) % 3]);
            const double inwards = dot(cross(n, unitVector(q - p)), x - p);
            if (inwards < least)
            {
                least = inwards;
                nearest = k;
            }
        }
        if (least > tolerance_)
        {
            found_.within[f].insert(point);
            note(point, 0, edgesOfCorner(corner), swapped);
            return;
        }
        if (least < -tolerance_) return;
        for (std::size_t k = 0; k < 3; ++k)
        {
            const auto e = edge(f, k);
            if (!(k == nearest && least >= 0) && !isOn(point, e)) continue;
            // A corner on an edge of its own facet is a matter of that facet alone.
            if (contains(corners(g), e[0]) && contains(corners(g), e[1])) continue;
            putOnEdge(e, point);
            note(point, 1u << k, edgesOfCorner(corner), swapped);
        }
    }

    /// Two edges that pass within the tolerance of each other between their ends.
    void edgesMeet(int f, std::size_t i, int g, std::size_t j)
    {
        const auto p = edge(f, i), q = edge(g, j);
        if (p[0] == q[0] || p[0] == q[1] || p[1] == q[0] || p[1] == q[1]) return;
        if (isOn(p[0], q) || isOn(p[1], q) || isOn(q[0], p) || isOn(q[1], p)) return;
        const auto u = at(p[1]) - at(p[0]), v = at(q[1]) - at(q[0]), r = at(p[0]) - at(q[0]);
        const double uu = dot(u, u), vv = dot(v, v), uv = dot(u, v), det = uu * vv - uv * uv;
        if (!(det > 1e-20 * uu * vv)) return; // parallel: their ends meet, or nothing
        const double s = (uv * dot(v, r) - vv * dot(u, r)) / det, t = (uu * dot(v, r) - uv * dot(u, r)) / det;
        if (!(s > 0 && s < 1 && t > 0 && t < 1)) return;
        const auto x = at(p[0]) + s * u, y = at(q[0]) + t * v;
        if (mag(x - y) > tolerance_) return;
        const int point = s_.points.add(0.5 * (x + y));
        putOnEdge(p, point);
        putOnEdge(q, point);
        note(point, 1u << i, 1u << j);
    }

    /// An edge of f that passes through the inside of g.
    void edgePierces(int f, std::size_t i, int g, bool swapped)
    {
        const auto e = edge(f, i);
        if (contains(corners(g), e[0]) || contains(corners(g), e[1])) return;
        const auto &a = at(corners(g)[0]), &b = at(corners(g)[1]), &c = at(corners(g)[2]);
        const auto n = unitVector(cross(b - a, c - a));
        const double from = dot(at(e[0]) - a, n), to = dot(at(e[1]) - a, n);
        if (from * to >= 0) return;
        const auto x = at(e[0]) + (from / (from - to)) * (at(e[1]) - at(e[0]));
        for (std::size_t k = 0; k < 3; ++k)
        {
            const auto &p = at(corners(g)[k]), &q = at(corners(g)[(k + 1) % 3]);
            // A point nearer to an edge is found as one of two edges that meet.
            if (dot(cross(n, unitVector(q - p)), x - p) <= 0.5 * tolerance_) return;
        }
        const int point = s_.points.add(x);
        putOnEdge(e, point);
        if (!contains(corners(g), point)) found_.within[g].insert(point);
        note(point, 1u << i, 0, swapped);
    }

    /// Whether a plane between the two facets keeps them apart, but for what they share: the usual case, found with little work.
    bool apart(int f, int g, int shared) const
    {
        const auto &a = corners(f), &b = corners(g);
        const auto isBeside = [&](const std::array<int, 3>& t, const std::array<int, 3>& others)
        {
            const auto n = unitVector(cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0])));
            double low = std::numeric_limits<double>::infinity(), high = -low;
            for (const int p : others)
            {
                const double h = dot(at(p) - at(t[0]), n);
                low = std::min(low, h);
                high = std::max(high, h);
            }
            return low > tolerance_ || high < -tolerance_;
        };
        if (shared == 0) return isBeside(a, b) || isBeside(b, a);
        Vector<3> alone[2], middle{}; // where each facet lies, as seen from what they share
        for (const int p : a)
            if (contains(b, p)) middle += at(p) / double(shared);
        for (int side = 0; side < 2; ++side)
            for (const int p : side == 0 ? a : b)
                if (!contains(side == 0 ? b : a, p)) alone[side] += at(p) / double(3 - shared);
        auto between = unitVector(alone[0] - middle) - unitVector(alone[1] - middle);
        if (shared == 2)
        {
            EdgeKey e{};
            std::copy_if(a.begin(), a.end(), e.begin(), [&](int p) { return contains(b, p); });
            const auto d = unitVector(at(e[1]) - at(e[0]));
            between -= dot(between, d) * d;
        }
        const double size = mag(between);
        if (!(size > 0)) return false;
        const auto all = [&](const std::array<int, 3>& t, const std::array<int, 3>& others, double sign)
        {
            return std::all_of(t.begin(), t.end(),
                               [&](int p) { return contains(others, p) || sign * dot(at(p) - middle, between) > tolerance_ * size; });
        };
        return all(a, b, 1) && all(b, a, -1);
    }

    /// Two facets that cross have the line between their two common points as a segment; two in one plane have each other's edges.
    void noteSegments(int f, int g)
    {
        const auto segment = [&](int facet, const Common& p, const Common& q, unsigned onSameEdge)
        {
            if (!onSameEdge) found_.intersected[facet].insert({std::min(p.point, q.point), std::max(p.point, q.point)});
        };
        if (common_.size() == 2)
        {
            segment(f, common_[0], common_[1], common_[0].onFirst & common_[1].onFirst);
            segment(g, common_[0], common_[1], common_[0].onSecond & common_[1].onSecond);
            return;
        }
        for (std::size_t k = 0; k < 3; ++k)
            for (const bool first : {true, false})
            {
                std::vector<Common> onEdge;
                std::copy_if(common_.begin(), common_.end(), std::back_inserter(onEdge),
                             [&](const Common& c) { return (first ? c.onFirst : c.onSecond) >> k & 1u; });
                const auto e = edge(first ? f : g, k);
                std::sort(onEdge.begin(), onEdge.end(),
                          [&](const Common& p, const Common& q) { return along(at(p.point), e) < along(at(q.point), e); });
                for (std::size_t i = 1; i < onEdge.size(); ++i)
                    segment(first ? g : f, onEdge[i - 1], onEdge[i],
                            first ? onEdge[i - 1].onSecond & onEdge[i].onSecond : onEdge[i - 1].onFirst & onEdge[i].onFirst);
            }
    }

public:
    Search(FacetSoup& s, Meetings& m) : s_(s), found_(m), tolerance_(nearness * s.points.tolerance()) {}

    void pair(int f, int g)
    {
        common_.clear();
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t j = 0; j < 3; ++j)
                if (corners(f)[i] == corners(g)[j]) note(corners(f)[i], edgesOfCorner(i), edgesOfCorner(j));
        const auto shared = common_.size();
        if (shared == 3) found_.pairs.push_back({f, g});
        if (shared == 3 || apart(f, g, int(shared))) return;
        for (std::size_t k = 0; k < 3; ++k)
        {
            if (!contains(corners(f), corners(g)[k])) cornerMeets(f, g, k, false);
            if (!contains(corners(g), corners(f)[k])) cornerMeets(g, f, k, true);
        }
        for (std::size_t i = 0; i < 3; ++i)
        {
            for (std::size_t j = 0; j < 3; ++j) edgesMeet(f, i, g, j);
            edgePierces(f, i, g, false);
            edgePierces(g, i, f, true);
        }
        if (common_.size() == shared) return;
        found_.pairs.push_back({f, g});
        noteSegments(f, g);
    }

    /// A facet lower than the tolerance: its tip belongs on the edge across.
    void self(int f)
    {
        for (std::size_t k = 0; k < 3; ++k)
            if (const int tip = corners(f)[(k + 2) % 3]; isOn(tip, edge(f, k))) putOnEdge(edge(f, k), tip);
    }
};

}

FacetSoup::FacetSoup(const NumberedMesh& m, double tolerance) : points(tolerance, boundingBox(m))
{
    std::vector<int> place;
    place.reserve(m.points.size());
    for (const auto& x : m.points) place.push_back(points.add(x));
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
    {
        auto t = m.triangles[f];
        for (int& p : t) p = place[std::size_t(p)];
        if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
        facets.push_back(t);
        source.push_back(int(f));
    }
}

Meetings findMeetings(FacetSoup& s, std::size_t first)
{
    using FacetBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
    std::vector<FacetBox> boxes;
    boxes.reserve(s.facets.size());
    const double margin = 0.5 * s.points.tolerance();
    for (std::size_t f = 0; f < s.facets.size(); ++f)
    {
        CGAL::Bbox_3 box;
        for (const int p : s.facets[f])
        {
            const auto& x = s.points[p];
            box += CGAL::Bbox_3(x.x - margin, x.y - margin, x.z - margin, x.x + margin, x.y + margin, x.z + margin);
        }
        boxes.emplace_back(box, int(f));
    }

    Meetings found;
    Search search(s, found);
    std::vector<const FacetBox*> all, changed;
    for (const auto& box : boxes) all.push_back(&box);
    changed.assign(all.begin() + std::ptrdiff_t(first), all.end());
    CGAL::box_intersection_d(changed.begin(), changed.end(), all.begin(), all.end(),
                             [&](const FacetBox* a, const FacetBox* b)
                             {
                                 const int f = a->info(), g = b->info();
                                 if (f != g && (g < int(first) || f < g)) search.pair(f, g);
                             });
    for (auto f = first; f < s.facets.size(); ++f) search.self(int(f));
    return found;
}

}
