#include "repairSurface.hpp"
#include "workingMesh.hpp"
#include <CGAL/Polygon_mesh_processing/self_intersections.h>

namespace sph
{

std::vector<std::array<int, 2>> selfIntersections(const NumberedMesh& m)
{
    const auto w = toWorkingMesh(m);
    std::vector<std::pair<FaceOf, FaceOf>> pairs;
    CGAL::Polygon_mesh_processing::self_intersections(w, std::back_inserter(pairs));
    std::vector<std::array<int, 2>> crossing;
    for (const auto& [a, b] : pairs)
    {
        // Parts may touch in a point that both have.
        bool touch = false;
        for (const auto u : w.vertices_around_face(w.halfedge(a)))
            for (const auto v : w.vertices_around_face(w.halfedge(b))) touch = touch || (u != v && w.point(u) == w.point(v));
        if (!touch) crossing.push_back({int(a), int(b)});
    }
    return crossing;
}

void checkSelfIntersections(const NumberedMesh& m, const std::string& remedy)
{
    const auto pairs = selfIntersections(m);
    if (pairs.empty()) return;
    std::vector<int> facets;
    for (const auto& pair : pairs) facets.insert(facets.end(), pair.begin(), pair.end());
    throw UnusableMesh("the surface crosses itself: " + counted(pairs.size(), "pair") + " of facets", m, facets, remedy);
}

}
