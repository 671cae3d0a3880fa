#include "meshes/repairSurface.hpp"
#include "meshes/workingMesh.hpp"
#include <CGAL/boost/graph/Euler_operations.h>
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{

using Edge = WorkingMesh::Edge_index;
using Halfedge = WorkingMesh::Halfedge_index;

class Slivers
{
    WorkingMesh w_;
    NumberOfFace region_, number_;
    double tolerance_;

    Vector<3> at(WorkingMesh::Vertex_index v) const { return toVector(w_.point(v)); }
    double length(Halfedge h) const { return mag(at(w_.target(h)) - at(w_.source(h))); }

    /// Height of a face over its longest edge, and that edge.
    std::pair<double, Halfedge> height(FaceOf f) const
    {
        auto longest = w_.halfedge(f);
        for (const auto h : w_.halfedges_around_face(longest))
            if (length(h) > length(longest)) longest = h;
        const auto a = at(w_.source(longest));
        return {mag(cross(at(w_.target(longest)) - a, at(w_.target(w_.next(longest))) - a)) / length(longest), longest};
    }

    /// Whether the faces around the source of h keep their orientation when it moves to the target.
    bool mayCollapse(Halfedge h) const
    {
        if (!CGAL::Euler::does_satisfy_link_condition(w_.edge(h), w_)) return false;
        const auto to = at(w_.target(h));
        for (const auto in : w_.halfedges_around_target(w_.opposite(h)))
        {
            const auto p = w_.source(in), q = w_.target(w_.next(in));
            if (p == w_.target(h) || q == w_.target(h)) continue;
            const auto from = at(w_.target(in));
            if (dot(cross(from - at(p), at(q) - at(p)), cross(to - at(p), at(q) - at(p))) <= 0) return false;
        }
        return true;
    }

public:
    Slivers(const NumberedMesh& m, double tolerance)
        : w_(toWorkingMesh(m)), region_(regionOf(w_)), number_(numberOf(w_)), tolerance_(tolerance)
    {}

    /// Collapses needles, and returns their number.
    std::size_t collapseNeedles()
    {
        std::vector<Edge> edges;
        for (const auto e : w_.edges())
            if (length(w_.halfedge(e)) < tolerance_) edges.push_back(e);
        std::size_t collapsed = 0;
        for (const auto e : edges)
        {
            if (w_.is_removed(e) || length(w_.halfedge(e)) >= tolerance_) continue;
            auto h = w_.halfedge(e);
            if (!mayCollapse(h)) h = w_.opposite(h);
            if (!mayCollapse(h)) continue;
            const auto to = w_.point(w_.target(h));
            w_.point(CGAL::Euler::collapse_edge(e, w_)) = to;
            ++collapsed;
        }
        return collapsed;
    }

    /// Flips caps, and returns their number. A flip makes no cap unless the neighbour is one as well.
    std::size_t flipCaps()
    {
        std::vector<FaceOf> caps;
        for (const auto f : w_.faces())
            if (height(f).first < tolerance_) caps.push_back(f);
        std::size_t flips = 0;
        for (const auto f : caps)
        {
            const auto [low, edge] = height(f);
            if (low >= tolerance_) continue;
            const auto tip = w_.target(w_.next(edge)), across = w_.target(w_.next(w_.opposite(edge)));
            if (w_.halfedge(tip, across) != WorkingMesh::null_halfedge()) continue;
            const auto other = w_.face(w_.opposite(edge));
            const double worst = std::min(low, height(other).first);
            CGAL::Euler::flip_edge(edge, w_);
            if (std::min(height(f).first, height(other).first) > worst)
            {
                region_[f] = region_[other];
                number_[f] = number_[other];
                ++flips;
            }
            else CGAL::Euler::flip_edge(edge, w_);
        }
        return flips;
    }

    std::size_t left() const
    {
        return std::size_t(std::count_if(w_.faces().begin(), w_.faces().end(), [&](FaceOf f) { return height(f).first < tolerance_; }));
    }

    void get(NumberedMesh& m) { fromWorkingMesh(w_, m); }
};

}

void removeSlivers(NumberedMesh& m, double tolerance, std::vector<std::string>& repairs)
{
    Slivers slivers(m, tolerance);
    if (slivers.left() == 0) return;
    std::size_t needles = 0, caps = 0;
    // A few rounds undo fans of them.
    for (int round = 0; round < 10; ++round)
    {
        const auto before = needles + caps;
        needles += slivers.collapseNeedles();
        caps += slivers.flipCaps();
        if (needles + caps == before) break;
    }
    slivers.get(m);
    if (needles > 0) repairs.push_back(fmt::format("{} shorter than {:.3g} m removed", counted(needles, "edge"), tolerance));
    if (caps > 0)
        repairs.push_back(fmt::format("{} lower than {:.3g} m removed by a flip of the longest edge", counted(caps, "facet"), tolerance));
    if (const auto left = slivers.left(); left > 0)
        repairs.push_back(fmt::format("{} lower than {:.3g} m left: without it the surface would fold", counted(left, "facet"), tolerance));
}

}
