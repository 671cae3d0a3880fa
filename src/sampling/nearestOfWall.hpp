/// The nearest place of one wall.
#pragma once
#include "geometry/forEachFoot.hpp"

namespace sph
{

/// The nearest foot of x on the patches of a wall, by its number, each by itself, periodic copies included.
inline NearestFoot nearestOfWall(const Geometry& geometry, std::size_t wall, const Vector<3>& x)
{
    NearestFoot nearest;
    nearest.foot.distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < geometry.patches.size(); ++k)
        if (std::size_t(geometry.patches[k].wall) == wall)
            if (const auto foot = geometry.patches[k].shape->foot(x); foot.distance < nearest.foot.distance) nearest = {foot, int(k)};
    return nearest;
}

}
