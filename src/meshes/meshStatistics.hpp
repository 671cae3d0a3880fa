/// Statistics of a mesh, in the words of OpenFOAM's surfaceCheck, and of what the kernel makes of it.
#pragma once
#include "geometry/Shape.hpp"
#include "meshes/readers/NumberedMesh.hpp"

namespace sph
{

/// Statistics of any triangles, closed or not.
struct MeshStatistics
{
    std::size_t triangles = 0, points = 0;
    std::vector<std::size_t> inRegion; ///< triangles of each
    Box box;
    std::size_t illegal = 0;                      ///< triangles without area
    std::array<std::size_t, 20> quality{};        ///< histogram from 0 to 1
    double leastQuality = 1, greatestQuality = 0; ///< area over that of the equilateral triangle with the same circumcircle
    struct Length
    {
        double length = 0; ///< [m]
        Vector<3> a, b;
    };
    Length shortest, longest; ///< edges
    std::size_t open = 0;     ///< edges of one facet
    std::size_t multiple = 0; ///< edges of more than two
    int parts = 0;            ///< connected by edges
    int zones = 0;            ///< connected by edges whose facets have the same orientation
    double volume = 0;        ///< [m^3], flux of x/3 through the surface: of no meaning where it is open or its orientation mixed
};
MeshStatistics meshStatistics(const NumberedMesh&);

/// Angle between the two facets of an edge, measured through the fluid [degrees]: above 180 where the solid is convex, below in its corners.
struct DihedralEdge
{
    int a, b; ///< points
    double angle;
};
/// Dihedral angles at the edges of a closed surface with normals into the fluid.
std::vector<DihedralEdge> dihedralEdges(const FacetSurface&);

/// Angle of a groove [degrees] from which on mirror images fill what lies behind its edge: the sum of W over particles and images is 0.83 of
/// that in the fluid at 15 degrees, 0.60 at 10, 0.32 at 5 (test MeshImages).
constexpr double leastFilled = 20;

/// Edges and angles of a closed surface with normals into the fluid.
struct MeshFeatures
{
    std::size_t convex = 0, concave = 0; ///< sharp edges: those that turn by more than the feature angle
    double most = 180, least = 180;      ///< dihedral angles [degrees] of the sharpest convex and concave edge
    Vector<3> mostAt, leastAt;
    std::size_t grooves = 0; ///< concave edges of less than `leastFilled`
    double smallest = 0;     ///< [m] square root of the smallest area that sharp edges bound
    Vector<3> smallestAt;
};
MeshFeatures meshFeatures(const FacetSurface&, const std::vector<DihedralEdge>&, double featureAngle);

/// Smooth parts where the fluid lies on the inside of a curve that is tighter than the kernel: facets joined by edges that turn by less than the feature
/// angle, faster than on a circle of the size of the support, and by more than the feature angle together (what is rough alone has no such part).
struct MeshHollows
{
    std::size_t count = 0;
    /// [m] of the tightest: R for which c - R n comes nearest to the middles of these edges, n the normals there
    double radius = Box::infinity;
    std::string facet; ///< of the file, where it turns fastest
    Vector<3> at;
};
MeshHollows meshHollows(const NumberedMesh&, const std::vector<DihedralEdge>&, double featureAngle, double support);

/// Distances between opposite facets (parallel within 30 degrees), along the normals in sampled points.
struct MeshClearances
{
    struct Place
    {
        double width = Box::infinity; ///< [m]
        Vector<3> at;
    };
    std::size_t sampled = 0;
    Place thinnest;  ///< of the solid
    Place narrowest; ///< of the fluid
};
/// Clearances in `samples` points spread evenly over the area, and in the centroids of as many facets, or of all.
MeshClearances meshClearances(const FacetSurface&, std::size_t samples = 20000);

}
