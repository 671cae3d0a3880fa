/// Facets as pieces that may lie in one another, and the places where they meet: surfaces that cross or touch are brought to meet in common
/// points and edges alone, and `removeSelfIntersections` takes what bounds the solid.
#pragma once
#include "meshes/WeldedPoints.hpp"
#include "meshes/readers/NumberedMesh.hpp"
#include <map>
#include <set>

namespace sph
{

/// Corners have the numbers of welded points: what meets in a point knows it by the number.
struct FacetSoup
{
    WeldedPoints points;
    std::vector<std::array<int, 3>> facets;
    std::vector<int> source; ///< triangle of the mesh that each is a part of

    /// Triangles with two corners within the tolerance [m] of each other are left out.
    FacetSoup(const NumberedMesh&, double tolerance);
};

using EdgeKey = std::array<int, 2>; ///< points, the lower first

/// Places where facets come within the tolerance of one another, other than in points and edges that they share.
struct Meetings
{
    std::vector<std::array<int, 2>> pairs;        ///< facets
    std::map<EdgeKey, std::set<int>> onEdge;      ///< points that belong on an edge
    std::map<int, std::set<int>> within;          ///< points that belong in the inside of a facet
    std::map<int, std::set<EdgeKey>> intersected; ///< facet -> segments that it has in common with another one
};
/// The meetings of the facets from `first` on with all. Points in which edges cross facets and edges are added to the soup.
Meetings findMeetings(FacetSoup&, std::size_t first = 0);

/// Splits edges and facets at their meetings until they meet in common points and edges alone; points, edges and facets nearer than the
/// tolerance are drawn to one another. False where the splits find no end.
bool splitWhereFacetsMeet(FacetSoup&, Meetings);

}
