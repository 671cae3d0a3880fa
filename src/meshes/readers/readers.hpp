/// A reader for each format, from the bytes of a file. For the sources of this module alone.
///
/// Each throws UnusableMesh with the line, byte or element where the file is not what its format says, and reads nothing that it does not
/// understand. `notes` gets what the file had and the mesh has not.
#pragma once
#include "meshes/readers/NumberedMesh.hpp"
#include <filesystem>
#include <string_view>

namespace sph
{

using Notes = std::vector<std::string>;

/// Binary where the length is that of its count of facets, or a zero byte stands before the end of the first facet, else ascii. A region
/// for the solids of one name; keywords in any case. Normals are those of the corners' order: what the file says of them is not looked
/// at.
NumberedMesh readStl(std::string_view bytes, Notes&);

/// Faces by v and f, a region for each name of the latest g or o. Materials make no regions, and what is of normals, textures and looks
/// is not looked at. Lines and points are left out with a note; what has no faces before it is evaluated (surf, call) is refused.
NumberedMesh readObj(std::string_view text, Notes&);

/// Ascii and binary of both byte orders, numbers of any type; faces by element `face` or strips by `tristrips`. Other elements are left
/// out with a note.
NumberedMesh readPly(std::string_view bytes, Notes&);

/// Ascii, three-dimensional; colours and normals of COFF, NOFF, STOFF are not looked at.
NumberedMesh readOff(std::string_view text, Notes&);

/// glTF 2.0, .gltf with its buffers, or .glb. Nodes of the scene are put in their places; a region for each material, or mesh where it
/// has none. Extensions that change the geometry are refused by name, but KHR_mesh_quantization, which is read.
NumberedMesh readGltf(const std::filesystem::path&, std::string_view bytes, Notes&);

}
