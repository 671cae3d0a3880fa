/// A volume of voxels, as a micro-CT scan gives it.
#pragma once
#include "base/Vector.hpp"
#include "geometry/triSurface.hpp"
#include <array>
#include <filesystem>
#include <vector>

namespace sph
{

struct VoxelImage
{
    std::array<int, 3> cells{1, 1, 1};
    Vector<3> voxel{1, 1, 1};  ///< edges, in the lengths of the file
    Vector<3> low;             ///< lowest corner of the volume
    std::vector<float> values; ///< x goes fastest
    bool isWhole = false;      ///< the values are whole numbers

    std::size_t size() const { return std::size_t(cells[0]) * std::size_t(cells[1]) * std::size_t(cells[2]); }
};

/// Voxels of a file: MetaImage (.mhd with its data beside it, .mha; uncompressed), whose header says what they are, or raw (any other name), of which the dictionary says it.
/// The centre of the first voxel lies at the header's Offset; where there is none the lowest corner of the volume lies at the origin. Throws UnusableMesh.
VoxelImage readVoxels(const std::filesystem::path&, const TriSurface::Volume&);

}
