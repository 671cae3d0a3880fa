#include "meshes/FacetSoup.hpp"
#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <algorithm>

namespace sph
{

namespace
{

using Plane = CGAL::Exact_predicates_inexact_constructions_kernel;
struct Number
{
    int point = -1; ///< -1: two segments cross there
};
struct Side
{
    bool outside = false;
};
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Number, Plane>;
using FaceBase = CGAL::Constrained_triangulation_face_base_2<Plane, CGAL::Triangulation_face_base_with_info_2<Side, Plane>>;
using Triangulation = CGAL::Constrained_Delaunay_triangulation_2<Plane, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                                                 CGAL::Exact_predicates_tag>;

/// Points on edges, in their order from the lower-numbered end: the same for all facets of the edge, so that what was closed stays so.
using Chains = std::map<EdgeKey, std::vector<int>>;

/// The parts of a facet: Delaunay's triangulation in its plane of the points on its edges and within it, the segments kept. Points on an edge
/// are taken on the straight line, those within at the foot of their normal.
class FacetParts
{
    FacetSoup& s_;
    const std::array<int, 3> corners_;
    Vector<3> origin_, u_, v_;
    Triangulation t_;
    std::map<int, Triangulation::Vertex_handle> vertices_;

    Plane::Point_2 flat(const Vector<3>& x) const { return {dot(x - origin_, u_), dot(x - origin_, v_)}; }
    Vector<3> raised(const Plane::Point_2& p) const { return origin_ + p.x() * u_ + p.y() * v_; }

    Triangulation::Vertex_handle insert(int point, const Plane::Point_2& p)
    {
        const auto vertex = t_.insert(p);
        if (vertex->info().point < 0) vertex->info().point = point;
        vertices_.try_emplace(point, vertex);
        return vertex;
    }

    void markOutside()
    {
        std::vector<Triangulation::Face_handle> next{t_.infinite_face()};
        next[0]->info().outside = true;
        while (!next.empty())
        {
            const auto face = next.back();
            next.pop_back();
            for (int k = 0; k < 3; ++k)
                if (const auto other = face->neighbor(k); !face->is_constrained(k) && !other->info().outside)
                {
                    other->info().outside = true;
                    next.push_back(other);
                }
        }
    }

public:
    FacetParts(FacetSoup& s, int facet) : s_(s), corners_(s.facets[std::size_t(facet)])
    {
        const auto &a = s.points[corners_[0]], &b = s.points[corners_[1]], &c = s.points[corners_[2]];
        origin_ = a;
        u_ = unitVector(b - a);
        v_ = cross(unitVector(cross(b - a, c - a)), u_);
    }

    void bound(const Chains& chains)
    {
        std::vector<Triangulation::Vertex_handle> ring;
        for (std::size_t k = 0; k < 3; ++k)
        {
            const int from = corners_[k], to = corners_[(k + 1) % 3];
            const auto p = flat(s_.points[from]), q = flat(s_.points[to]);
            ring.push_back(insert(from, p));
            const auto chain = chains.find({std::min(from, to), std::max(from, to)});
            if (chain == chains.end()) continue;
            auto points = chain->second;
            if (from > to) std::reverse(points.begin(), points.end());
            const auto d = s_.points[to] - s_.points[from];
            for (const int point : points)
                ring.push_back(insert(point, p + dot(s_.points[point] - s_.points[from], d) / dot(d, d) * (q - p)));
        }
        for (std::size_t i = 0; i < ring.size(); ++i) t_.insert_constraint(ring[i], ring[(i + 1) % ring.size()]);
    }

    void fill(const std::set<int>& points, const std::set<EdgeKey>& segments)
    {
        for (const int point : points) insert(point, flat(s_.points[point]));
        for (const auto& [a, b] : segments)
            if (const auto from = vertices_.find(a), to = vertices_.find(b);
                from != vertices_.end() && to != vertices_.end() && from->second != to->second)
                t_.insert_constraint(from->second, to->second);
    }

    /// Appends the parts; those that have two corners in one point have no area and are left out.
    void append(std::vector<std::array<int, 3>>& parts)
    {
        for (const auto vertex : t_.finite_vertex_handles())
            if (auto& number = vertex->info().point; number < 0) number = s_.points.add(raised(vertex->point()));
        markOutside();
        for (const auto face : t_.finite_face_handles())
        {
            const int a = face->vertex(0)->info().point, b = face->vertex(1)->info().point, c = face->vertex(2)->info().point;
            if (!face->info().outside && a != b && b != c && c != a) parts.push_back({a, b, c});
        }
    }
};

Chains inOrder(const FacetSoup& s, const std::map<EdgeKey, std::set<int>>& onEdge)
{
    Chains chains;
    for (const auto& [edge, points] : onEdge)
    {
        auto& chain = chains[edge];
        chain.assign(points.begin(), points.end());
        const auto from = s.points[edge[0]], d = s.points[edge[1]] - from;
        std::stable_sort(chain.begin(), chain.end(), [&](int a, int b) { return dot(s.points[a] - from, d) < dot(s.points[b] - from, d); });
    }
    return chains;
}

/// The changed facets come last; the number of the others.
std::size_t split(FacetSoup& s, const Meetings& m)
{
    const auto chains = inOrder(s, m.onEdge);
    const auto isSplit = [&](int a, int b) { return chains.contains({std::min(a, b), std::max(a, b)}); };
    const auto of = [](const auto& map, int facet)
    {
        const auto found = map.find(facet);
        return found == map.end() ? typename std::decay_t<decltype(map)>::mapped_type{} : found->second;
    };
    std::vector<std::array<int, 3>> kept, parts;
    std::vector<int> keptSource, partSource;
    for (std::size_t f = 0; f < s.facets.size(); ++f)
    {
        const auto& [a, b, c] = s.facets[f];
        const auto within = of(m.within, int(f));
        if (within.empty() && !isSplit(a, b) && !isSplit(b, c) && !isSplit(c, a))
        {
            kept.push_back(s.facets[f]);
            keptSource.push_back(s.source[f]);
            continue;
        }
        FacetParts facetParts(s, int(f));
        facetParts.bound(chains);
        facetParts.fill(within, of(m.intersected, int(f)));
        facetParts.append(parts);
        partSource.resize(parts.size(), s.source[f]);
    }
    const auto unchanged = kept.size();
    kept.insert(kept.end(), parts.begin(), parts.end());
    keptSource.insert(keptSource.end(), partSource.begin(), partSource.end());
    s.facets = std::move(kept);
    s.source = std::move(keptSource);
    return unchanged;
}

}

bool splitWhereFacetsMeet(FacetSoup& s, Meetings m)
{
    // Splits move edges by up to the tolerance, after which others may meet: two or three rounds settle it, or none.
    constexpr int rounds = 8;
    for (int round = 0; round < rounds; ++round)
    {
        if (m.onEdge.empty() && m.within.empty()) return true;
        const auto first = split(s, m);
        m = findMeetings(s, first);
    }
    return false;
}

}
