/// The one way to the surfaces around a point: all that are near, or the nearest.
#pragma once
#include "geometry/Geometry.hpp"
#include "geometry/PatchGrid.hpp"
#include "geometry/TriangleMesh.hpp"
#include <span>

namespace sph
{

/// Calls f(foot, patch), by its index, for each foot of x within `reach` [m] (and behind a surface) that bounds the fluid: on the faces, edges
/// and vertices (Foot::on) of the patches `near`. A patch may have several feet; f sees them one after the other, patches ascending.
template<class F> void forEachFoot(const Geometry& g, std::span<const int> near, const Vector<3>& x, double reach, const F& f)
{
    for (const int p : near)
        if (const auto* mesh = g.patches[std::size_t(p)].mesh)
            mesh->body().forEachFoot(mesh->local(x), std::min(reach, g.reach),
                                     [&](Foot foot)
                                     {
                                         if (g.mayBeCovered(p)) foot.exposure = g.exposure(p, x, foot);
                                         if (foot.exposure > 0) f(foot, p);
                                     });
        else if (const Foot foot = g.foot(p, x); foot.distance <= reach && foot.exposure > 0) f(foot, p);
}

/// Calls f for the patches that the geometry's own grid knows, for reach up to Geometry::reach.
template<class F> void forEachFoot(const Geometry& g, const Vector<3>& x, double reach, const F& f)
{
    forEachFoot(g, g.grid->near(x), x, reach, f);
}

/// Calls f for each shape by itself, whatever other solids cover of it, and for any reach: the smallest of these distances is that to the union
/// of all solids, also for an x in several of them, whose feet may all be covered.
template<class F> void forEachFootAlone(const Geometry& g, const Vector<3>& x, double reach, const F& f)
{
    const auto look = [&](int p)
    {
        if (const Foot foot = g.patches[std::size_t(p)].shape->foot(x); foot.distance <= reach) f(foot, p);
    };
    if (g.grid && reach <= g.reach)
        for (const int p : g.grid->near(x)) look(p);
    else
        for (int p = 0; p < int(g.patches.size()); ++p) look(p);
}

struct NearestFoot
{
    Foot foot;      ///< infinitely far where there is none
    int patch = -1; ///< where there are no walls, or x is NaN
};

/// The nearest foot of x on the shapes by themselves, one patch left out, at any distance; of patches that are as near the first.
NearestFoot nearestFoot(const Geometry&, const Vector<3>& x, int except = -1);

}
