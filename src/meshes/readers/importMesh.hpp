/// Triangles of a file as other programs write them: STL (ascii and binary), OBJ, PLY, OFF, glTF.
#pragma once
#include "meshes/readers/NumberedMesh.hpp"
#include <filesystem>

namespace sph
{

/// Each format by a reader of its own, in double precision where the file has it: a file is read as it is meant or refused, with line or
/// byte. Polygons are cut into triangles, nodes of a glTF scene put in their places. A region each for the solids of an ascii STL, the
/// groups of an OBJ and the materials of a glTF (its meshes, where they have none); else one, `patch0`. Names become words of a
/// dictionary. `notes` gets what the file had and the mesh has not. Single precision is read as the decimal numbers of fewest digits that
/// it stands for. Throws UnusableMesh.
NumberedMesh importMesh(const std::filesystem::path&, std::vector<std::string>& notes);

}
