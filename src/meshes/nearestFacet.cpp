#include "meshes/TriangleTree.hpp"
#include "meshes/repairSurface.hpp"
#include <cmath>

namespace sph
{

void takeRegions(NumberedMesh& to, const NumberedMesh& from)
{
    const TriangleTree facets(from);
    to.regions = from.regions;
    for (std::size_t f = 0; f < to.triangles.size(); ++f)
    {
        const auto nearest = facets.tree().closest_point_and_primitive(TriangleTree::point(centroid(to, int(f)))).second;
        to.region[f] = from.region[std::size_t(facets.facet(nearest))];
    }
}

Distance largestDistance(const NumberedMesh& from, const NumberedMesh& to)
{
    const TriangleTree facets(to);
    Distance most;
    for (const auto& x : from.points)
        if (const double d = std::sqrt(facets.tree().squared_distance(TriangleTree::point(x))); d > most.length) most = {d, x};
    return most;
}

}
