/// The surface of the solid in a volume of voxels.
#pragma once
#include "geometry/triSurface.hpp"
#include "meshes/readers/NumberedMesh.hpp"
#include <filesystem>

namespace sph
{

/// Marching cubes on the values at the centres of the voxels, along
///
///     value = threshold                         where a threshold is given: between two grey values the surface lies where a straight line has the threshold
///     (G_s * 1_solid) = iso                     where a label is given: the indicator of the solid, smoothed by Gauss's kernel of standard deviation s (`smoothing`, in voxels)
///
/// Smoothing takes the steps of the voxels away, and shrinks what is round by s^2/R; `iso` is therefore the value that as many voxels exceed as are solid, which keeps the volume. The
/// solid is closed where the volume ends, by planes in the outer faces of its voxels. `notes` gets the voxels, their porosity and that of the surface. Throws UnusableMesh.
NumberedMesh importVolume(const std::filesystem::path&, const TriSurface::Volume&, std::vector<std::string>& notes);

}
