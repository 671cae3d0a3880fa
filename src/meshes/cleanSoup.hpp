/// Conversion of loose triangles to a surface: each point once, each facet once, neighbours with the same orientation.
#pragma once
#include "meshes/readers/NumberedMesh.hpp"
#include <string>
#include <vector>

namespace sph
{

/// Points within `tolerance` [m] of each other become one (the first of them); facets with a corner twice go.
void weldPoints(NumberedMesh&, double tolerance, std::vector<std::string>& repairs);

/// Removes equal facets but one, and all where each has its opposite: a face that separated two bodies lies within one.
void removeDuplicates(NumberedMesh&, std::vector<std::string>& repairs);

/// Parts the bodies that meet in an edge of four facets or more, so that each has its own: facets that bound one solid wedge there belong
/// together, or those of one region, where the orientation does not tell. What is left is a matter of `checkManifold`.
void splitEdges(NumberedMesh&);

/// Throws UnusableMesh where more than two facets meet in an edge.
void checkManifold(const NumberedMesh&);

/// Turns facets until neighbours go through their edge in opposite directions. Which way a part is turned as a whole is left open: as most
/// of its facets were. Throws UnusableMesh where there is no such orientation (a Moebius strip).
void orientFacets(NumberedMesh&, std::vector<std::string>& repairs);

/// A point in which parts meet that share no edge there becomes one point for each of them.
void splitPoints(NumberedMesh&, std::vector<std::string>& repairs);

/// Keeps the facets for which `keep(facet)` holds; their number.
std::size_t dropFacets(NumberedMesh& m, const auto& keep)
{
    std::size_t kept = 0;
    const auto before = m.triangles.size();
    for (std::size_t f = 0; f < before; ++f)
    {
        if (!keep(f)) continue;
        m.triangles[kept] = m.triangles[f];
        m.region[kept] = m.region[f];
        m.number[kept++] = m.number[f];
    }
    m.triangles.resize(kept);
    m.region.resize(kept);
    m.number.resize(kept);
    return before - kept;
}

/// Drops points of no facet.
void removeUnusedPoints(NumberedMesh&);

}
