#include "FacetTree.hpp"
#include "repairSurface.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

void takeRegions(NumberedMesh& to, const NumberedMesh& from)
{
    const FacetTree facets(from);
    to.regions = from.regions;
    for (std::size_t f = 0; f < to.triangles.size(); ++f)
    {
        const auto nearest = facets.tree().closest_point_and_primitive(FacetTree::point(centroid(to, int(f)))).second;
        to.region[f] = from.region[std::size_t(facets.facet(nearest))];
    }
}

double largestDistance(const NumberedMesh& from, const NumberedMesh& to)
{
    const FacetTree facets(to);
    double most = 0;
    for (const auto& x : from.points) most = std::max(most, facets.tree().squared_distance(FacetTree::point(x)));
    return std::sqrt(most);
}

}
