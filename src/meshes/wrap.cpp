#include "geometry/Shape.hpp"
#include "meshes/repairSurface.hpp"
#include "meshes/workingMesh.hpp"
#include <CGAL/alpha_wrap_3.h>
#include <fmt/format.h>

namespace sph
{

void wrap(NumberedMesh& m, const TriSurface::Wrap& w, std::vector<std::string>& repairs)
{
    std::vector<Kernel::Point_3> points;
    for (const auto& p : m.points) points.push_back(toPoint(p));
    WorkingMesh wrapped;
    const double offset = 0.5 * w.tolerance;
    CGAL::alpha_wrap_3(points, m.triangles, w.alpha, offset, wrapped);
    NumberedMesh result;
    result.regions = m.regions;
    fromWorkingMesh(wrapped, result);
    if (result.triangles.empty()) throw UnusableMesh("the wrap is empty: its alpha is too large for the mesh");
    takeRegions(result, m);
    const auto [outside, there] = largestDistance(result, m);
    const auto [within, here] = largestDistance(m, result);
    repairs.push_back(fmt::format("{} wrapped with {}: alpha {:.4g} m, offset {:.4g} m", counted(m.triangles.size(), "facet"),
                                  counted(result.triangles.size(), "facet"), w.alpha, offset));
    repairs.push_back(fmt::format("the wrap is at most {:.3g} m outside the mesh, at {}", outside, inWords(there)));
    repairs.push_back(fmt::format("the mesh is at most {:.3g} m within the wrap, at {}{}", within, inWords(here),
                                  within > w.tolerance ? ", more than the tolerance: what is narrower than 2 alpha is bridged" : ""));
    m = std::move(result);
}

}
