/// The one way to the surfaces around a point.
#pragma once
#include "Geometry.hpp"
#include "PatchGrid.hpp"
#include <span>

namespace sph
{

/// Calls f(foot, patch), by its index, for each foot of x within `reach` [m] (and behind a surface) that bounds the fluid: on the faces, edges
/// and vertices (Foot::on) of the patches `near`. A patch may have several feet; f sees them one after the other, patches ascending.
template<class F> void forEachFoot(const Geometry& g, std::span<const int> near, const Vector<3>& x, double reach, const F& f)
{
    for (const int p : near)
        if (const Foot foot = g.foot(p, x); foot.distance <= reach && foot.exposure > 0) f(foot, p);
}

/// The same of all patches that the geometry's own grid knows, for reach up to Geometry::reach.
template<class F> void forEachFoot(const Geometry& g, const Vector<3>& x, double reach, const F& f)
{
    forEachFoot(g, g.grid->near(x), x, reach, f);
}

}
