/// Triangles of a file as other programs write them: STL (ascii and binary), OBJ, PLY, OFF, glTF.
#pragma once
#include "NumberedMesh.hpp"
#include "triSurface.hpp"
#include <filesystem>

namespace sph
{

/// Polygons are cut into triangles, nodes of a glTF scene put in their places. A region each for the solids of an ascii STL, the groups of
/// an OBJ and the materials of a glTF (its meshes, where they have none); else one, `patch0`. Names become words of a dictionary. `notes`
/// gets what the file had and the mesh has not. Coordinates have seven digits, as assimp keeps them: the fewest that say the same number. Throws UnusableMesh.
NumberedMesh importMesh(const std::filesystem::path&, std::vector<std::string>& notes);

/// By scale, rotation and translation of the dictionary.
void place(NumberedMesh&, const TriSurface&);
/// Points nearer than this are one where the dictionary does not say [m].
double weldOf(const Box&);

}
