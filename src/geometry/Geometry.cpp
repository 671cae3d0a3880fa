#include "geometry/Geometry.hpp"
#include "geometry/PatchGrid.hpp"
#include "geometry/PatchTree.hpp"
#include "geometry/components.hpp"
#include "geometry/forEachFoot.hpp"
#include "geometry/periodicShifts.hpp"
#include <algorithm>

namespace sph
{

namespace
{

NearestPatch nearest(const Geometry& g, const Vector<3>& x, NearestPatch best = {}, int except = -1)
{
    if (g.tree) return g.tree->nearest(x, best, except);
    for (int p = 0; p < int(g.patches.size()); ++p)
        if (const double d = g.patches[std::size_t(p)].shape->foot(x).distance; p != except && d < best.distance) best = {d, p};
    return best;
}

}

double Geometry::distance(const Vector<3>& x) const
{
    auto best = nearest(*this, x);
    if (best.distance <= reach) return best.distance;

    // No surface within reach: the copies that were made may not hold the nearest one. Those one period further do.
    forEachPeriodicShift(*this, [&](const Vector<3>& by) { best = nearest(*this, x + by, best); });
    return best.distance;
}

bool Geometry::inFluid(const Vector<3>& x) const
{
    if (!grid) return nearest(*this, x).distance > 0;
    const auto near = grid->near(x);
    return std::all_of(near.begin(), near.end(),
                       [&](int p)
                       {
                           const auto& patch = patches[std::size_t(p)];
                           // A mesh knows of most places without a search that they lie before it.
                           return isBeyond(patch.mesh, x, 0) || patch.shape->foot(x).distance > 0;
                       });
}

Vector<3> Geometry::wallVelocity(int wall, const Vector<3>& x) const
{
    const auto& w = walls[wall];
    return w.velocity + cross(w.omega, x - w.origin);
}

NearestFoot nearestFoot(const Geometry& g, const Vector<3>& x, int except)
{
    NearestFoot found;
    found.patch = nearest(g, x, {}, except).patch;
    if (found.patch < 0) found.foot.distance = Box::infinity;
    else found.foot = g.patches[std::size_t(found.patch)].shape->foot(x);
    return found;
}

bool Geometry::bends() const
{
    return std::ranges::any_of(patches, [](const Patch& p)
                               { return p.shape->smallestRadius() < std::numeric_limits<double>::infinity() || p.shape->hasEdges(); });
}

double Geometry::length(int direction) const { return high.*component(direction) - low.*component(direction); }

Vector<3> Geometry::shortest(Vector<3> way) const
{
    for (int k = 0; k < dimension; ++k)
        if (double& d = way.*component(k); periodic[std::size_t(k)] && std::fabs(d) > 0.5 * length(k))
            d -= length(k) * std::round(d / length(k));
    return way;
}

}
