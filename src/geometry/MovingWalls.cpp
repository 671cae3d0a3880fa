#include "geometry/MovingWalls.hpp"
#include "geometry/Plane.hpp"

namespace sph
{

bool movesAcross(const Geometry& g, const Patch& patch)
{
    const auto& wall = g.walls[std::size_t(patch.wall)];
    const auto* plane = dynamic_cast<const Plane*>(patch.shape.get());
    return plane && wall.omega == Vector<3>{} &&
           std::abs(dot(wall.velocity, plane->foot({}).normal)) > slidingTolerance * mag(wall.velocity);
}

MovingWalls::MovingWalls(Geometry& g)
{
    for (std::size_t p = 0; p < g.patches.size(); ++p)
    {
        const auto& patch = g.patches[p];
        if (!movesAcross(g, patch)) continue;
        const auto velocity = g.walls[std::size_t(patch.wall)].velocity;
        moving_.push_back({p, patch.shape, patch.shape->foot({}).normal, velocity});
        fastest_ = std::max(fastest_, mag(velocity));
    }
    if (!any()) return;
    g.grid.reset();
    g.tree.reset();
}

double MovingWalls::speedAlong(const Vector<3>& normal) const
{
    for (const auto& wall : moving_)
        if (dot(wall.normal, normal) > 1 - 1e-9) return dot(wall.normal, wall.velocity);
    return 0;
}

void MovingWalls::advance(Geometry& g, double deltaT)
{
    time_ += deltaT;
    for (const auto& wall : moving_) g.patches[wall.patch].shape = wall.atStart->shifted(time_ * wall.velocity);
}

}
