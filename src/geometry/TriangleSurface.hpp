/// Triangulated surfaces for looking at walls and for sampling them; the solver never sees them.
#pragma once
#include "base/Vector.hpp"
#include <array>
#include <functional>
#include <vector>

namespace sph
{

struct Box;

struct TriangleSurface
{
    std::vector<Vector<3>> points;
    std::vector<std::array<int, 3>> triangles;
};

/// The image of the unit square under `point(u, v)` in nu x nv cells of two triangles each; those without area (poles) are left
/// out.
TriangleSurface parametricSurface(int nu, int nv, const std::function<Vector<3>(double u, double v)>& point);

/// Cells along an arc of that length [m] for edges no longer than `size`, within limits that keep circles round and files small.
int segments(double length, double size);

/// The part of a surface within the box: triangles that cross its sides are cut there.
TriangleSurface cropped(const TriangleSurface&, const Box&);

void append(TriangleSurface& to, const TriangleSurface& more);

/// Two unit vectors that make a right-handed system with the unit vector `axis`: {e1, e2, axis}.
std::array<Vector<3>, 2> crossSection(const Vector<3>& axis);

/// Corners of a box, which must be finite.
std::array<Vector<3>, 8> corners(const Box&);

}
