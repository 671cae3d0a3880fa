/// Meshes to look at with ParaView, in constant/triSurface.
#pragma once
#include "meshes/meshStatistics.hpp"
#include "meshes/readers/NumberedMesh.hpp"

namespace sph
{

/// constant/triSurface/<wall>.edges.vtp: edges and facets; cell arrays `angle` (dihedral angle of the fluid [degrees], 180 of facets), `kind`
/// (1 convex, -1 concave, 0 neither: turns by less than the feature angle, or is a facet) and `region` (-1 of edges).
std::string writeEdges(const std::filesystem::path& caseFolder, const std::string& wall, const FacetSurface&,
                       const std::vector<DihedralEdge>&, double featureAngle);

/// constant/triSurface/<wall>.defects.vtp: the facets and edges that are to blame.
std::string writeDefects(const std::filesystem::path& caseFolder, const std::string& wall, const UnusableMesh&);
/// Takes away what an earlier run has written.
void removeDefects(const std::filesystem::path& caseFolder, const std::string& wall);

}
