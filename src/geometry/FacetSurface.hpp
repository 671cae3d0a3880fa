/// A closed surface of triangles as the solver takes it: welded, oriented, without holes, prepared by meshToGhost from a mesh that a person has made.
///
/// On disk, constant/wallMeshes/<wall>, numbers in the shortest form that reads back to the same double:
///
///     FoamFile { ... }
///     regions ( shell lid )
///     points  8 ( (0 0 0) (1 0 0) ... )                   [m]
///     facets  12 ( (0 2 1 0) ... )                        three points and the region, counter-clockwise as seen from the fluid
#pragma once
#include "dictionary/Dictionary.hpp"
#include "geometry/TriangleSurface.hpp"
#include <filesystem>
#include <string>
#include <vector>

namespace sph
{

struct FacetSurface : TriangleSurface
{
    std::vector<std::string> regions; ///< names, at least one
    std::vector<int> region;          ///< of each triangle, index into `regions`
};

/// `constant/wallMeshes/<wall>` of a case.
std::string wallMeshFile(const std::string& wall);

void writeWallMesh(const std::filesystem::path& caseFolder, const std::string& wall, const FacetSurface&);

/// An empty surface, and an error that names file and line, where the file is missing or damaged.
FacetSurface readWallMesh(const std::filesystem::path& caseFolder, const std::string& wall, Diagnostics&);

}
