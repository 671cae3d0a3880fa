#include "repairSurface.hpp"
#include "workingMesh.hpp"
#include <CGAL/boost/graph/Euler_operations.h>
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{

/// Twice the area over the longest edge, and that edge.
std::pair<double, WorkingMesh::Halfedge_index> height(const WorkingMesh& w, FaceOf f)
{
    auto longest = w.halfedge(f);
    double most = 0;
    for (const auto h : w.halfedges_around_face(w.halfedge(f)))
        if (const double l = CGAL::squared_distance(w.point(w.source(h)), w.point(w.target(h))); l > most)
        {
            most = l;
            longest = h;
        }
    const auto &a = w.point(w.source(longest)), &b = w.point(w.target(longest)), &c = w.point(w.target(w.next(longest)));
    return {mag(cross(toVector(b) - toVector(a), toVector(c) - toVector(a))) / std::sqrt(most), longest};
}

}

void removeCaps(NumberedMesh& m, double tolerance, std::vector<std::string>& repairs)
{
    auto w = toWorkingMesh(m);
    std::vector<FaceOf> caps;
    for (const auto f : w.faces())
        if (height(w, f).first < tolerance) caps.push_back(f);
    if (caps.empty()) return;
    auto region = regionOf(w), number = numberOf(w);
    std::size_t flips = 0;
    // A flip makes no cap unless the neighbour is one as well: a few rounds undo fans of them.
    for (int round = 0; round < 10; ++round)
    {
        const auto before = flips;
        for (const auto f : caps)
        {
            const auto [low, edge] = height(w, f);
            if (low >= tolerance || w.is_border(w.opposite(edge))) continue;
            const auto tip = w.target(w.next(edge)), across = w.target(w.next(w.opposite(edge)));
            if (w.halfedge(tip, across) != WorkingMesh::null_halfedge()) continue;
            const auto other = w.face(w.opposite(edge));
            const double worst = std::min(low, height(w, other).first);
            CGAL::Euler::flip_edge(edge, w);
            if (std::min(height(w, f).first, height(w, other).first) > worst)
            {
                region[f] = region[other];
                number[f] = number[other];
                ++flips;
            }
            else CGAL::Euler::flip_edge(edge, w);
        }
        if (flips == before) break;
    }
    const auto left = std::count_if(caps.begin(), caps.end(), [&](FaceOf f) { return height(w, f).first < tolerance; });
    fromWorkingMesh(w, m);
    if (flips > 0) repairs.push_back(counted(flips, "facet") + " without area removed by a flip of the longest edge");
    if (left > 0) repairs.push_back(counted(std::size_t(left), "facet") + " without area could not be removed");
}

}
