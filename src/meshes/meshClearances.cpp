#include "meshes/TriangleTree.hpp"
#include "meshes/meshStatistics.hpp"
#include <boost/variant/get.hpp>

namespace sph
{

MeshClearances meshClearances(const FacetSurface& s, std::size_t samples)
{
    constexpr double parallel = 0.8660254037844387; // cos 30 degrees

    const TriangleTree facets(s);
    MeshClearances result;
    const auto look = [&](std::size_t f, const Vector<3>& x)
    {
        const auto n = unitVector(areaVector(s, int(f)));
        ++result.sampled;
        for (const double side : {1.0, -1.0})
        {
            const TriangleTree::Kernel::Ray_3 ray(TriangleTree::point(x), TriangleTree::point(x + side * n));
            const auto hit = facets.tree().first_intersection(ray, [&](const auto& other) { return facets.facet(other) == int(f); });
            const auto* there = hit ? boost::get<TriangleTree::Kernel::Point_3>(&hit->first) : nullptr;
            if (!there) continue;
            const auto m = areaVector(s, facets.facet(hit->second));
            if (dot(m, n) > -parallel * mag(m)) continue;
            const double width = mag(Vector<3>{there->x(), there->y(), there->z()} - x);
            auto& least = side > 0 ? result.narrowest : result.thinnest;
            if (width < least.width) least = {width, x};
        }
    };

    double area = 0;
    for (std::size_t f = 0; f < s.triangles.size(); ++f) area += mag(areaVector(s, int(f)));
    const double share = area / double(samples);
    const auto step = std::max<std::size_t>(1, s.triangles.size() / samples);
    double passed = 0;
    std::size_t taken = 0;
    for (std::size_t f = 0; f < s.triangles.size(); ++f)
    {
        const double own = mag(areaVector(s, int(f)));
        if (!(own > 0)) continue;
        passed += own;
        if (f % step == 0) look(f, centroid(s, int(f)));
        const auto &a = s.points[std::size_t(s.triangles[f][0])], &b = s.points[std::size_t(s.triangles[f][1])],
                   &c = s.points[std::size_t(s.triangles[f][2])];
        for (; double(taken) * share < passed - 0.5 * share; ++taken)
        {
            // Points of low discrepancy in the unit square (Roberts 2018, R2), folded into the triangle.
            double u = std::fmod(0.7548776662466927 * double(taken), 1), v = std::fmod(0.5698402909980532 * double(taken), 1);
            if (u + v > 1)
            {
                u = 1 - u;
                v = 1 - v;
            }
            look(f, a + u * (b - a) + v * (c - a));
        }
    }
    return result;
}

}
