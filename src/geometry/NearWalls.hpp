/// Walls around a particle: the patches that may be near, their feet, and the nearest foot.
#pragma once
#include "geometry/crevice.hpp"

namespace sph
{

class NearWalls
{
    const Geometry* geometry_;
    PatchGrid grid_;

public:
    /// Finds walls within `reach` [m] of a place. The geometry must outlive them.
    NearWalls(const Geometry& geometry, double reach) : geometry_(&geometry), grid_(geometry, reach) {}

    /// Patches that may be within reach of x, by index, ascending.
    std::span<const int> patches(const Vector<3>& x) const { return grid_.near(x); }

    /// Calls f(foot, patch) for each patch within `reach` [m] of x, no more than images are, also where an edge or a vertex is the nearest place of the
    /// patch and there is no image, but not where that place lies in another solid. In meshes a search takes as long as its reach is wide.
    template<class F> void forEachFoot(const Vector<3>& x, double reach, const F& f) const
    {
        sph::forEachFoot(*geometry_, patches(x), x, reach, [&](const Foot& foot, int p) { f(foot, geometry_->patches[std::size_t(p)]); });
    }

    /// The narrowest crevice at x among those narrower than `narrowest` [m].
    Crevice crevice(const Vector<3>& x, double narrowest) const { return creviceAt(*geometry_, patches(x), x, narrowest); }

    /// The nearest foot of x within `reach` [m] that bounds the fluid, on a face, an edge or a vertex, or one that is infinitely far.
    NearestFoot nearestFoot(const Vector<3>& x, double reach) const;
};

}
