#include "meshes/FacetSoup.hpp"
#include "meshes/repairSurface.hpp"

namespace sph
{

void checkSelfIntersections(const NumberedMesh& m, double tolerance, const std::string& remedy)
{
    FacetSoup soup(m, tolerance);
    const auto pairs = findMeetings(soup).pairs;
    if (pairs.empty()) return;
    std::vector<int> facets;
    for (const auto& pair : pairs)
        for (const int f : pair) facets.push_back(soup.source[std::size_t(f)]);
    throw UnusableMesh("the surface crosses or touches itself: " + counted(pairs.size(), "pair") + " of facets", m, facets, remedy);
}

}
