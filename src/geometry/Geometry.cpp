#include "Geometry.hpp"
#include "PatchGrid.hpp"
#include "PatchTree.hpp"
#include "components.hpp"
#include "periodicShifts.hpp"
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
    forEachPeriodicShift(*this, [&](const Vector<3>& by) { d = smaller(x + by, d); });
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
