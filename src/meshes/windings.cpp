#include "meshes/windings.hpp"
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/box_intersection_d.h>
#include <limits>

namespace sph
{

Crossings crossingsOf(const TriangleSurface& s, int axis, const std::vector<AxisLine>& lines)
{
    using Plane = CGAL::Exact_predicates_inexact_constructions_kernel;
    using LineBox = CGAL::Box_intersection_d::Box_with_info_d<double, 2, int>;
    const auto flat = [&](int point)
    {
        const auto& x = s.points[std::size_t(point)];
        return axis == 0 ? Plane::Point_2(x.y, x.z) : axis == 1 ? Plane::Point_2(x.z, x.x) : Plane::Point_2(x.x, x.y);
    };
    std::vector<LineBox> ofLines, ofFacets;
    for (std::size_t i = 0; i < lines.size(); ++i) ofLines.emplace_back(Plane::Point_2(lines[i].u, lines[i].v).bbox(), int(i));
    for (std::size_t f = 0; f < s.triangles.size(); ++f)
    {
        const auto& [a, b, c] = s.triangles[f];
        ofFacets.emplace_back(flat(a).bbox() + flat(b).bbox() + flat(c).bbox(), int(f));
    }

    Crossings found;
    found.grazes.assign(lines.size(), 0);
    CGAL::box_intersection_d(ofLines.begin(), ofLines.end(), ofFacets.begin(), ofFacets.end(),
                             [&](const LineBox& line, const LineBox& facet)
                             {
                                 const auto& [a, b, c] = s.triangles[std::size_t(facet.info())];
                                 const auto& at = lines[std::size_t(line.info())];
                                 const Plane::Point_2 x(at.u, at.v), p = flat(a), q = flat(b), r = flat(c);
                                 const int turns[] = {CGAL::orientation(p, q, x), CGAL::orientation(q, r, x), CGAL::orientation(r, p, x)};
                                 bool left = false, right = false, on = false;
                                 for (const int turn : turns)
                                 {
                                     left = left || turn > 0;
                                     right = right || turn < 0;
                                     on = on || turn == 0;
                                 }
                                 if (left && right) return;
                                 if (on) found.grazes[std::size_t(line.info())] = 1;
                                 else found.all.push_back({line.info(), facet.info(), left ? 1 : -1});
                             });
    return found;
}

}
