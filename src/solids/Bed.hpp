/// Solids where they have come to rest.
#pragma once
#include "geometry/Shape.hpp"
#include "geometry/TriangleSurface.hpp"
#include "solids/Rotation.hpp"
#include "solids/entries/SolidsPlan.hpp"
#include <functional>
#include <span>

namespace sph
{

/// A sphere of diameter 1, or a mesh of the same volume with its centroid at the origin.
struct SolidShape
{
    std::string name;     ///< of its group in constant/triSurface/solids.obj
    std::string file;     ///< empty: a sphere
    TriangleSurface mesh; ///< empty: a sphere
    Vector<3> centroid;   ///< in the file's coordinates
    double fileSize = 1;  ///< diameter of the sphere of equal volume there
    double reach = 0.5;   ///< largest distance from the centroid
    CollisionForm form = CollisionForm::automatic;
    std::vector<TriangleSurface> pieces; ///< grain and fines, whose union the mesh of an agglomerate is; else empty
    std::string note;                    ///< for the log: what an agglomerate is made of
    Location where;

    bool isSphere() const { return mesh.triangles.empty(); }
    bool isAgglomerate() const { return !pieces.empty(); }
};

/// Throws CaseError where the file is missing, or the surface is open, inside out or empty. The seed decides where fines are bound.
SolidShape readSolidShape(const Case&, const ShapeToPack&, std::uint64_t seed = 1);

/// A grain with fines bound to it (agglomerate.cpp), its file that of constant/triSurface which writeBed writes. `fine` has size 1 and its centroid at the origin.
SolidShape agglomerate(const SolidShape& grain, const TriangleSurface& fine, const FinesToBind&, std::uint64_t seed);

/// A solid in the frame of the container: z against gravity, the origin at its base.
struct Body
{
    int shape = 0;
    double size = 1; ///< diameter of the sphere of equal volume
    Vector<3> centre;
    Rotation rotation;
    double shrunk = 0; ///< share of its size that it had more when it was poured
};

struct Contact
{
    int i, j;
    double gap; ///< negative: overlap
};

struct Bed
{
    std::vector<SolidShape> shapes;
    std::vector<Body> bodies;
    double meanSize = 1;
    double time = 0, kineticEnergy = 0; ///< in sqrt(d/g), and mean of a body in m g d
    double overlap = 0;                 ///< largest before shrinking, over the mean size
    double sizeFactor = 1;              ///< by which all sizes differ from those that were asked for
    int takenAway = 0;                  ///< for standing out of the top
    int taps = 0;                       ///< of the container, until the bed was as dense as it was to be
    std::vector<Contact> contacts;
    std::vector<std::string> notes;

    const SolidShape& shapeOf(const Body& b) const { return shapes[std::size_t(b.shape)]; }
    double reachOf(const Body& b) const { return b.size * shapeOf(b).reach; }
};

using Progress = std::function<void(const std::string&)>;

/// Solids by the plan, sizes and shapes in random order, randomly turned, and nowhere yet.
std::vector<Body> drawBodies(const SolidsPlan&, int count);

/// Rigid bodies that fall into the container, which is tapped where a porosity is asked for. Throws CaseError where they do not come to rest, or do not become as dense.
void settle(const SolidsPlan&, Bed&, const Progress&);

/// Spheres at their final places and sizes. Throws CaseError where the porosity cannot be reached.
void packRandomly(const SolidsPlan&, Bed&, const Progress&);

/// Packs solids: all that packParticles -solids does, but for the files.
Bed packSolids(const Case&, const SolidsPlan&, const Progress&);

/// The difference of two places as the periodic directions make it shortest.
Vector<3> shortest(const SolidContainer&, Vector<3> difference);

/// Pairs (i < j) nearer than the sum of their reaches and the margin.
std::vector<std::pair<int, int>> nearPairs(const SolidContainer&, std::span<const Vector<3>> centres, std::span<const double> reach,
                                           double margin);

/// Depth by which a solid reaches into another, or into the container (j = -1) [m].
struct Overlap
{
    int i, j;
    double depth;
};

/// Of spheres exact; of meshes the depth of the deepest point of an edge of one below the surface of the other. None of solids whose facets do not cross.
std::vector<Overlap> findOverlaps(const SolidContainer&, const Bed&);
/// The largest depth; 0 without any.
double deepest(const std::vector<Overlap>&);
double largestOverlap(const SolidContainer&, const Bed&);

/// Height below which 90 % of the solids end; of randomClose that of the container [m].
double heightOf(const SolidsPlan&, const Bed&);
/// Porosity of the middle half of the height over the whole cross-section, exact but for overlaps.
double porosityOfMiddle(const SolidsPlan&, const Bed&);

/// Bodies as surfaces in space.
TriangleSurface placed(const SolidContainer&, const SolidShape&, const Body&);

}
