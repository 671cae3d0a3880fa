/// The triangles that a wall is made from.
#pragma once
#include "geometry/triSurface.hpp"
#include "meshes/readers/importMesh.hpp"
#include "meshes/volumes/importVolume.hpp"

namespace sph
{

/// They come from a mesh, or from the solid in a volume of voxels. Throws UnusableMesh.
inline NumberedMesh importSource(const std::filesystem::path& file, const TriSurface& t, std::vector<std::string>& notes)
{
    return t.volume ? importVolume(file, *t.volume, notes) : importMesh(file, notes);
}

}
