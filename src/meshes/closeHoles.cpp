#include "geometry/Shape.hpp"
#include "meshes/repairSurface.hpp"
#include "meshes/workingMesh.hpp"
#include <CGAL/Polygon_mesh_processing/border.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// The diagonal of the box around a border [m].
double widthOf(const WorkingMesh& w, WorkingMesh::Halfedge_index border)
{
    TriangleSurface ring;
    for (const auto h : w.halfedges_around_face(border)) ring.points.push_back(toVector(w.point(w.target(h))));
    const auto box = boundingBox(ring);
    return mag(box.high - box.low);
}

}

void closeHoles(NumberedMesh& m, std::optional<double> widest, std::vector<std::string>& repairs)
{
    std::vector<std::array<int, 2>> open;
    std::vector<int> facets;
    forEachEdge(sortedHalfEdges(m),
                [&](std::span<const HalfEdge> edge)
                {
                    if (edge.size() != 1) return;
                    open.push_back({edge[0].low, edge[0].high});
                    facets.push_back(edge[0].facet);
                });
    if (open.empty()) return;

    auto w = toWorkingMesh(m);
    std::vector<WorkingMesh::Halfedge_index> holes;
    CGAL::Polygon_mesh_processing::extract_boundary_cycles(w, std::back_inserter(holes));
    double width = 0;
    for (const auto h : holes) width = std::max(width, widthOf(w, h));
    if (!widest || width > *widest)
        throw UnusableMesh(fmt::format("the surface is open: {} of one facet only, around {}, the widest {:.4g} m across",
                                       counted(open.size(), "edge"), counted(holes.size(), "hole"), width),
                           m, open, facets,
                           fmt::format("Close them: closeHoles {:.2g}; or wrap the mesh: wrap {{ tolerance ...; }}", 1.01 * width));

    auto region = regionOf(w), number = numberOf(w);
    std::size_t made = 0;
    for (const auto h : holes)
    {
        const int around = region[w.face(w.opposite(h))];
        std::vector<FaceOf> patch;
        CGAL::Polygon_mesh_processing::triangulate_hole(w, h, std::back_inserter(patch));
        for (const auto f : patch)
        {
            region[f] = around;
            number[f] = -1;
        }
        made += patch.size();
    }
    fromWorkingMesh(w, m);
    repairs.push_back(
        fmt::format("{} closed with {}, the widest {:.4g} m across", counted(holes.size(), "hole"), counted(made, "facet"), width));
    // A ring that crosses itself has no triangulation.
    closeHoles(m, std::nullopt, repairs);
}

}
