/// Walls that stand for the other half of a scene.
#pragma once
#include "geometry/Geometry.hpp"
#include "geometry/Plane.hpp"

namespace sph
{

/// Planes along which the fluid slides freely (`slip yes;`), their periodic copies with them.
inline std::vector<const Shape*> planesOfSymmetry(const Geometry& geometry)
{
    std::vector<const Shape*> planes;
    for (const auto& patch : geometry.patches)
        if (const auto* plane = dynamic_cast<const Plane*>(patch.shape.get()); plane && geometry.walls[std::size_t(patch.wall)].slips)
            planes.push_back(plane);
    return planes;
}

}
