#include "meshes/placeMesh.hpp"
#include <cmath>
#include <numbers>

namespace sph
{

void place(NumberedMesh& m, const TriSurface& t)
{
    // Rodrigues: x cos + (k x x) sin + k (k.x)(1 - cos); right angles exactly.
    const double turns = t.angle / 90;
    const bool right = turns == std::round(turns);
    const auto quarter = int(std::fmod(std::fmod(turns, 4) + 4, 4));
    const double c = right ? (quarter == 0) - (quarter == 2) : std::cos(t.angle * std::numbers::pi / 180),
                 s = right ? (quarter == 1) - (quarter == 3) : std::sin(t.angle * std::numbers::pi / 180);
    for (auto& x : m.points)
    {
        const auto y = t.scale * x;
        x = c * y + s * cross(t.axis, y) + (1 - c) * dot(t.axis, y) * t.axis + t.translation;
    }
}

double weldOf(const Box& box) { return 1e-6 * mag(box.high - box.low); }

}
