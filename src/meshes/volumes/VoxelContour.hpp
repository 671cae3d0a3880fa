/// The surface on which values at the nodes of a grid have one value: marching cubes, which the library libsphVoxels.so has of VTK. What has no volumes loads neither.
#pragma once
#include <array>
#include <vector>

namespace sph
{

struct VoxelContour
{
    std::vector<std::array<float, 3>> points; ///< in steps of the grid from its first node
    std::vector<std::array<int, 3>> triangles;
};

/// The function that libsphVoxels.so has under the name `contourVoxels`; x goes fastest.
using ContourVoxels = void(const std::array<int, 3>& nodes, const float* values, double iso, VoxelContour&);

}
