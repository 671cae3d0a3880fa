/// A wall of `type triSurface`: a file of triangles in constant/triSurface, where it is put in the scene, and what may be repaired in it.
/// meshToGhost prepares it (src/meshes); all other programs read what that has written (FacetSurface.hpp).
#pragma once
#include "dictionary/EntryList.hpp"
#include "geometry/Shape.hpp"
#include <array>

namespace sph
{

struct TriSurface
{
    std::string wall, file; ///< `file` relative to constant/triSurface
    Location at, scaleAt;   ///< of `file` and of `scale` in constant/geometry
    FluidSide fluid = FluidSide::outside;

    // x -> R(axis, angle) (scale x) + translation
    double scale = 1;
    Vector<3> axis{0, 0, 1};
    double angle = 0; ///< [degrees]
    Vector<3> translation;

    std::optional<double> weld;       ///< [m] points nearer to each other are one
    std::optional<double> closeHoles; ///< [m] holes no wider than this are closed
    bool removeSelfIntersections = false;
    struct Wrap
    {
        double tolerance, alpha; ///< [m]
    };
    std::optional<Wrap> wrap;
    std::optional<double> edgeLength; ///< [m] of the facets that remeshing makes
    double featureAngle = 30;         ///< [degrees] between the normals of facets; edges that turn more are kept

    /// What a volume of voxels is, where the file is one.
    struct Volume
    {
        std::optional<double> threshold, label; ///< one of them
        bool solidBelow = false;                ///< of the threshold, not from it on
        double smoothing = 0;                   ///< [voxels] standard deviation
        std::optional<double> voxelSize;        ///< in the lengths of the file
        // of a raw file
        std::array<int, 3> cells{1, 1, 1};
        std::string dataType;
        bool bigEndian = false;
        int headerBytes = 0;
    };
    std::optional<Volume> volume;

    std::vector<std::string> regions; ///< those with properties of their own
};

TriSurface readTriSurface(const Dictionary& wall);

/// Sub-dictionaries of `regions`, each named as a region of the file.
std::vector<Dictionary> regionsOf(const Dictionary& wall);

/// `ofRegion`: what the dictionary of a region may hold.
EntryList triSurfaceEntries(const EntryList& ofRegion = {});

}
