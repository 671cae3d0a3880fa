/// The surface of the solid in a volume of voxels.
#pragma once
#include "geometry/triSurface.hpp"
#include "meshes/readers/NumberedMesh.hpp"
#include <filesystem>

namespace sph
{

/// Marching cubes on the values at the centres of the voxels, along
///
///     value = threshold            grey values as they are: between two voxels the surface lies where a straight line has the threshold
///     G_s * 1_solid = iso          where a label is given, or smoothing: the indicator of the solid voxels, smoothed by Gauss's kernel of standard deviation s (`smoothing`, in voxels)
///
/// Smoothing takes away the steps of the voxels, and shrinks what is round by s^2/R; `iso` is therefore the value whose surface encloses the volume of the solid voxels, to 1e-5 of the whole. The
/// solid is closed where the volume ends, by planes in the outer faces of its voxels. `notes` gets the voxels, their porosity and that of the surface. Throws UnusableMesh.
NumberedMesh importVolume(const std::filesystem::path&, const TriSurface::Volume&, std::vector<std::string>& notes);

}
