/// Surfaces on disk: VTP, STL and OBJ.
#pragma once
#include <filesystem>
#include <span>
#include <string>
#include <vtkPolyData.h>

namespace sph
{

/// "vtp", "stl", "obj"
std::span<const std::string> surfaceFormats();

/// True where a mesh of that dimension can be written so: STL knows triangles only, hence no 2-D contour lines.
bool canHold(const std::string& format, int dimension);

/// Writes binary VTP, binary STL or OBJ by the extension of `file`, beside its name and renamed when whole; makes the folder.
/// Throws CaseError where that fails.
void writeSurface(vtkPolyData*, const std::filesystem::path& file);

}
