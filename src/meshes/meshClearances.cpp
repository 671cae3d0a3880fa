#include "FacetTree.hpp"
#include "meshStatistics.hpp"
#include <boost/variant/get.hpp>

namespace sph
{

MeshClearances meshClearances(const FacetSurface& s, std::size_t samples)
{
    constexpr double parallel = 0.8660254037844387; // cos 30 degrees

    const FacetTree facets(s);
    MeshClearances result;
    const auto step = std::max<std::size_t>(1, s.triangles.size() / samples);
    for (std::size_t f = 0; f < s.triangles.size(); f += step)
    {
        const auto a = areaVector(s, int(f));
        if (!(mag(a) > 0)) continue;
        const auto n = unitVector(a), x = centroid(s, int(f));
        ++result.sampled;
        for (const double side : {1.0, -1.0})
        {
            const FacetTree::Kernel::Ray_3 ray(FacetTree::point(x), FacetTree::point(x + side * n));
            const auto hit = facets.tree().first_intersection(ray, [&](const auto& other) { return facets.facet(other) == int(f); });
            const auto* there = hit ? boost::get<FacetTree::Kernel::Point_3>(&hit->first) : nullptr;
            if (!there) continue;
            const auto m = areaVector(s, facets.facet(hit->second));
            if (dot(m, n) > -parallel * mag(m)) continue;
            const double width = mag(Vector<3>{there->x(), there->y(), there->z()} - x);
            auto& least = side > 0 ? result.narrowest : result.thinnest;
            if (width < least.width) least = {width, x};
        }
    }
    return result;
}

}
