/// Repairs of a surface that is manifold and oriented, by the algorithms of CGAL (Polygon Mesh Processing, 3D Alpha Wrapping).
#pragma once
#include "geometry/triSurface.hpp"
#include "meshes/readers/NumberedMesh.hpp"
#include <algorithm>

namespace sph
{

/// Facets lower than `tolerance` [m] have no normal to speak of. Those with a short edge go by its collapse, the others by a flip of the longest
/// edge: the surface moves by no more than the tolerance. Those that are left (without them it would fold) are counted.
void removeSlivers(NumberedMesh&, double tolerance, std::vector<std::string>& repairs);

/// Fills holes with triangles (Liepa 2003), if none is wider than `widest` [m]; what fills them belongs to the region around. Throws
/// UnusableMesh where edges stay open, and says how wide the widest hole is.
void closeHoles(NumberedMesh&, std::optional<double> widest, std::vector<std::string>& repairs);

/// Distance within which surfaces touch, of those within which points are welded and would be by default [m]: where nothing is to be welded, what is
/// nearer than rounding brings it touches all the same.
inline double contactOf(double weld, double byDefault) { return std::max(weld, 1e-3 * byDefault); }
/// Throws UnusableMesh where facets cross or touch others within `tolerance` [m], other than in points and edges that they have in common.
void checkSelfIntersections(const NumberedMesh&, double tolerance, const std::string& remedy);
/// The boundary of the solid where closed surfaces cross or touch one another or themselves: of all around which one of them winds (winding number
/// not zero), without what lies in their cavities. Facets are split where they meet (within `tolerance` [m] they meet), and those kept that have
/// solid on one side: Zhou et al. (2016), Mesh arrangements for solid geometry, ACM Trans. Graph. 35. Throws UnusableMesh where the result has not
/// the box, or not the volume, that the mesh encloses. The tolerance within which parts of the result are apart: a smaller one where facets are
/// as small as that given.
double removeSelfIntersections(NumberedMesh&, double tolerance, std::vector<std::string>& repairs);

/// A volume by lines through it, and its standard error.
struct EnclosedByLines
{
    double volume = 0, error = 0; ///< [m^3]
    std::size_t lines = 0;
};
/// Throws UnusableMesh, which says how much, where `repaired` has not the box of the mesh, or not the volume that it encloses: six standard errors and
/// what the tolerance [m] may change along the surface are allowed.
void checkNothingIsLost(const NumberedMesh& repaired, const NumberedMesh&, const EnclosedByLines&, double tolerance);

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
