#include "Geometry.hpp"
#include "PatchGrid.hpp"
#include "PatchTree.hpp"
#include "components.hpp"
#include <algorithm>

namespace sph
{

namespace
{

double nearest(const std::vector<Patch>& patches, const Vector<3>& x, double best = Box::infinity)
{
    for (const auto& p : patches) best = std::min(best, p.shape->foot(x).distance);
    return best;
}

}

double Geometry::distance(const Vector<3>& x) const
{
    const auto smaller = [&](const Vector<3>& y, double best)
    { return tree ? tree->distance(y, best) : nearest(patches, y, best); };
    double d = smaller(x, Box::infinity);
    if (d <= reach) return d;

    // No surface within reach: the copies that were made may not hold the nearest one. Those one period further do.
    for (int i = periodic[0] ? -1 : 0; i <= int(periodic[0]); ++i)
        for (int k = periodic[1] ? -1 : 0; k <= int(periodic[1]); ++k)
            for (int l = periodic[2] ? -1 : 0; l <= int(periodic[2]); ++l)
                if (i != 0 || k != 0 || l != 0) d = smaller(x + Vector<3>{i * length(0), k * length(1), l * length(2)}, d);
    return d;
}

bool Geometry::inFluid(const Vector<3>& x) const
{
    if (!grid) return nearest(patches, x) > 0;
    const auto near = grid->near(x);
    return std::all_of(near.begin(), near.end(), [&](int p) { return patches[p].shape->foot(x).distance > 0; });
}

Vector<3> Geometry::wallVelocity(int wall, const Vector<3>& x) const
{
    const auto& w = walls[wall];
    return w.velocity + cross(w.omega, x - w.origin);
}

double Geometry::length(int direction) const { return high.*component(direction) - low.*component(direction); }

}
