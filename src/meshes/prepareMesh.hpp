/// Preparation of a wall from a file of triangles: read, put in its place, checked, repaired as far as the dictionary asks for it, and measured.
#pragma once
#include "geometry/triSurface.hpp"
#include "meshes/MeshSpace.hpp"
#include "meshes/meshStatistics.hpp"

namespace sph
{

struct PreparedMesh
{
    TriSurface source;
    std::vector<std::string> notes;   ///< what the file had and the mesh has not
    std::vector<std::string> repairs; ///< in their order
    std::vector<std::string> regions; ///< names
    MeshStatistics asRead;            ///< in its place, points welded
    bool usable = false;              ///< what follows is there
    FacetSurface surface;
    MeshStatistics prepared;
    std::vector<DihedralEdge> edges;
    MeshFeatures features;
    MeshClearances clearances;
    MeshHollows hollows;
};

/// Mistakes go to the Diagnostics, with facets, coordinates and a VTP file that shows them (meshFiles.hpp); so do warnings of solids thinner
/// than two supports of the kernel and of hollows tighter than one.
PreparedMesh prepareMesh(const std::filesystem::path& caseFolder, const TriSurface&, const MeshSpace&, Diagnostics&);

/// Writes the wall (FacetSurface.hpp) and its edges (meshFiles.hpp); the names of the files.
std::vector<std::string> writePrepared(const std::filesystem::path& caseFolder, const PreparedMesh&);

/// Repairs and main figures; `full`: as OpenFOAM's surfaceCheck tells, and what of the mesh the kernel cannot resolve.
std::string meshReport(const PreparedMesh&, double H, bool full);

}
