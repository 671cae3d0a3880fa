/// The walls as triangles in files that ParaView and OpenFOAM's surface tools open.
#pragma once
#include "geometry/Geometry.hpp"
#include <string>
#include <vector>

namespace sph
{

/// One surface for each of Geometry::walls, periodic copies included, cut off `margin` [m] outside the domain; edges of about
/// `size`. A 2-D scene becomes a slice of thickness `size`.
std::vector<TriangleSurface> wallSurfaces(const Geometry&, double margin, double size);

/// ascii STL with a region `solid <name>` for each wall, normals into the fluid.
std::string stlText(const Geometry&, const std::vector<TriangleSurface>&);

/// ascii VTK XML PolyData with cell arrays `wall` (number in the order of constant/geometry) and `contactAngle`,
/// of several the first.
std::string vtpText(const Geometry&, const std::vector<TriangleSurface>&);

}
