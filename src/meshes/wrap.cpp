#include "Shape.hpp"
#include "repairSurface.hpp"
#include "workingMesh.hpp"
#include <CGAL/alpha_wrap_3.h>
#include <fmt/format.h>

namespace sph
{

void wrap(NumberedMesh& m, const TriSurface::Wrap& w, std::vector<std::string>& repairs)
{
    std::vector<Kernel::Point_3> points;
    for (const auto& p : m.points) points.push_back(toPoint(p));
    WorkingMesh wrapped;
    CGAL::alpha_wrap_3(points, m.triangles, w.alpha, w.tolerance, wrapped);
    NumberedMesh result;
    result.regions = m.regions;
    fromWorkingMesh(wrapped, result);
    if (result.triangles.empty()) throw UnusableMesh("the wrap is empty: its alpha is too large for the mesh");
    takeRegions(result, m);
    repairs.push_back(
        fmt::format("{} wrapped with {}: alpha {:.4g} m, offset {:.4g} m; the wrap is at most {:.4g} m from the mesh, the mesh "
                    "{:.4g} m from the wrap",
                    counted(m.triangles.size(), "facet"), counted(result.triangles.size(), "facet"), w.alpha, w.tolerance,
                    largestDistance(result, m), largestDistance(m, result)));
    m = std::move(result);
}

}
