#include "orientShells.hpp"
#include "repairSurface.hpp"
#include "workingMesh.hpp"
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/repair_self_intersections.h>
#include <fmt/format.h>
#include <map>

namespace sph
{

namespace
{

namespace pmp = CGAL::Polygon_mesh_processing;

}

void removeSelfIntersections(NumberedMesh& m, std::vector<std::string>& repairs)
{
    const auto pairs = selfIntersections(m);
    if (pairs.empty()) return;
    const auto shells = findShells(m);
    std::map<int, std::size_t> within; // shells that cross themselves, and in how many pairs
    DisjointSets bodies(std::size_t(shells.count));
    std::size_t between = 0;
    for (const auto& [f, g] : pairs)
    {
        const int a = shells.of[std::size_t(f)], b = shells.of[std::size_t(g)];
        if (a == b) ++within[a];
        else
        {
            bodies.join(a, b);
            ++between;
        }
    }

    const auto [setOf, sets] = bodies.numbered();
    std::map<int, WorkingMesh> unions; // by the number of the set
    const auto parts = apart(m, shells);
    for (int s = 0; s < shells.count; ++s)
    {
        auto part = toWorkingMesh(parts[std::size_t(s)]);
        if (shells.volume[std::size_t(s)] < 0) pmp::reverse_face_orientations(part);
        if (within.contains(s))
        {
            pmp::experimental::remove_self_intersections(part);
            repairs.push_back(fmt::format("{} of facets of one surface that cross cut out and filled", counted(within[s], "pair")));
        }
        const auto [body, isFirst] = unions.try_emplace(setOf[std::size_t(s)], part);
        if (isFirst) continue;
        WorkingMesh both;
        if (!pmp::corefine_and_compute_union(body->second, part, both))
            throw UnusableMesh("bodies that cross each other have no union that is a surface: the facets that cross", m,
                               [&]
                               {
                                   std::vector<int> all;
                                   for (const auto& pair : pairs) all.insert(all.end(), pair.begin(), pair.end());
                                   return all;
                               }());
        body->second = std::move(both);
    }
    if (between > 0)
        repairs.push_back(fmt::format("{} that cross in {} of facets united to {}", counted(std::size_t(shells.count), "closed surface"),
                                      counted(between, "pair"), sets));

    NumberedMesh result;
    result.regions = m.regions;
    for (auto& [number, body] : unions)
    {
        NumberedMesh part;
        fromWorkingMesh(body, part);
        const int offset = int(result.points.size());
        result.points.insert(result.points.end(), part.points.begin(), part.points.end());
        for (const auto& [a, b, c] : part.triangles) result.triangles.push_back({a + offset, b + offset, c + offset});
    }
    result.region.assign(result.triangles.size(), 0);
    result.number.assign(result.triangles.size(), -1);
    takeRegions(result, m);
    m = std::move(result);
}

}
