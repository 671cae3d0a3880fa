/// The nearest place of one wall, or of those along which nothing slides freely.
#pragma once
#include "geometry/forEachFoot.hpp"

namespace sph
{

/// The nearest foot of x on the patches whose wall, by its number, is chosen, each by itself, periodic copies included.
template<class Choose> NearestFoot nearestOfWalls(const Geometry& geometry, const Vector<3>& x, const Choose& isChosen)
{
    NearestFoot nearest;
    nearest.foot.distance = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < geometry.patches.size(); ++k)
        if (isChosen(std::size_t(geometry.patches[k].wall)))
            if (const auto foot = geometry.patches[k].shape->foot(x); foot.distance < nearest.foot.distance) nearest = {foot, int(k)};
    return nearest;
}

inline NearestFoot nearestOfWall(const Geometry& geometry, std::size_t wall, const Vector<3>& x)
{
    return nearestOfWalls(geometry, x, [wall](std::size_t w) { return w == wall; });
}

/// Distance to the nearest wall that is no plane of symmetry [m].
inline double nearestThatHolds(const Geometry& geometry, const Vector<3>& x)
{
    return nearestOfWalls(geometry, x, [&](std::size_t w) { return !geometry.walls[w].slips; }).foot.distance;
}

}
