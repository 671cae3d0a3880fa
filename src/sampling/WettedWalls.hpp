/// The wetted area of each wall: that on which liquid stands.
#pragma once
#include "sampling/WallTriangles.hpp"
#include <vector>

namespace sph
{

struct WettedWall
{
    double area = 0, wetted = 0; ///< [m^2], per metre of depth [m] in 2-D
    WettedWall& operator+=(const WettedWall& other)
    {
        area += other.area;
        wetted += other.wetted;
        return *this;
    }
    double share() const { return area > 0 ? wetted / area : 0; }
};

/// The wetted areas of Geometry::walls within a region, without what lies in another solid.
///
///   wetted = area of { x on the wall: C(x) > 1/2 },   C(x) = sum_j w_j C_j  min(1, sum_j V_j W_j/D)
///
/// C_j is 1 in the liquid and 0 in other phases, w_j the weights that are exact for linear fields (Interpolator): they carry the colour from the
/// particles to the wall itself, half a spacing and more away from them, so that it does not depend on the spacing where the liquid's surface
/// meets the wall. D is the part of the kernel's sphere that lies in the fluid's space: beyond the surface of a liquid whose gas is left out C
/// falls to 0. The walls are small triangles (WallTriangles), C varies linearly over each, and its area is cut at 1/2./// Verified by WettedWalls of test/unit/sampling, on planes, boxes and spheres, at three resolutions.
class WettedWalls
{
    WallTriangles triangles_;

public:
    /// Walls of the view's geometry, for its resolution.
    WettedWalls(const ParticleView&, const Box& region);
    /// Each wall by the particles of a view of the same scene.
    std::vector<WettedWall> operator()(const ParticleView&, std::size_t liquid);
};

}
