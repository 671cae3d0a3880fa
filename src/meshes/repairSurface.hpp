/// Repairs of a surface that is manifold and oriented, by the algorithms of CGAL (Polygon Mesh Processing, 3D Alpha Wrapping).
#pragma once
#include "NumberedMesh.hpp"
#include "triSurface.hpp"

namespace sph
{

/// Facets lower than `tolerance` [m] have no normal to speak of. Those with a short edge go by its collapse, the others by a flip of the longest
/// edge: the surface moves by no more than the tolerance. Those that are left (without them it would fold) are counted.
void removeSlivers(NumberedMesh&, double tolerance, std::vector<std::string>& repairs);

/// Fills holes with triangles (Liepa 2003), if none is wider than `widest` [m]; what fills them belongs to the region around. Throws
/// UnusableMesh where edges stay open, and says how wide the widest hole is.
void closeHoles(NumberedMesh&, std::optional<double> widest, std::vector<std::string>& repairs);

/// Pairs of facets that cross or touch each other without sharing an edge or a point there.
std::vector<std::array<int, 2>> selfIntersections(const NumberedMesh&);
/// Throws UnusableMesh where there are some.
void checkSelfIntersections(const NumberedMesh&, const std::string& remedy);
/// Closed surfaces that cross one another become one, the boundary of their union; what crosses itself within one is cut out and filled.
void removeSelfIntersections(NumberedMesh&, std::vector<std::string>& repairs);

/// A closed surface around all facets, at a distance of half the tolerance: Portaneri et al. (2022), Alpha wrapping with an offset, ACM Trans. Graph.
/// 41. Its facets belong to the region of the nearest facet of the mesh.
void wrap(NumberedMesh&, const TriSurface::Wrap&, std::vector<std::string>& repairs);

/// Facets of one size, edges about `edgeLength` [m] long: Botsch & Kobbelt (2004), A remeshing approach to multiresolution modeling. Kept are
/// edges that turn by more than `featureAngle` [degrees], and those between regions.
void remesh(NumberedMesh&, double edgeLength, double featureAngle, std::vector<std::string>& repairs);

/// The regions and numbers of `from`, each facet of `to` by the nearest facet there.
void takeRegions(NumberedMesh& to, const NumberedMesh& from);
struct Distance
{
    double length = 0; ///< [m]
    Vector<3> at;
};
/// The largest distance of points of `from` to facets of `to`.
Distance largestDistance(const NumberedMesh& from, const NumberedMesh& to);

}
