#include "geometry/MovingWalls.hpp"
#include "geometry/Plane.hpp"
#include "geometry/TriangleMesh.hpp"
#include "geometry/components.hpp"

namespace sph
{

bool movesAcross(const Geometry& g, const Patch& patch)
{
    const auto& wall = g.walls[std::size_t(patch.wall)];
    if (!(wall.omega == Vector<3>{}) || dynamic_cast<const TriangleMesh*>(patch.shape.get())) return false;
    const auto& v = wall.velocity;
    if (const auto* plane = dynamic_cast<const Plane*>(patch.shape.get()))
        return std::abs(dot(v, plane->foot({}).normal)) > slidingTolerance * mag(v);
    for (int k = 0; k < g.dimension; ++k)
        if (std::abs(v.*component(k)) > slidingTolerance * mag(v) && !patch.shape->invariantAlong(k)) return true;
    return false;
}

MovingWalls::MovingWalls(Geometry& g)
{
    for (std::size_t p = 0; p < g.patches.size(); ++p)
    {
        const auto& patch = g.patches[p];
        if (!movesAcross(g, patch)) continue;
        const auto velocity = g.walls[std::size_t(patch.wall)].velocity;
        moving_.push_back({p, patch.shape, velocity});
        fastest_ = std::max(fastest_, mag(velocity));
    }
    if (!any()) return;
    g.grid.reset();
    g.tree.reset();
}

double MovingWalls::speedAlong(int patch, const Vector<3>& n) const
{
    for (const auto& wall : moving_)
        if (int(wall.patch) == patch) return dot(n, wall.velocity);
    return 0;
}

void MovingWalls::advance(Geometry& g, double deltaT)
{
    time_ += deltaT;
    for (const auto& wall : moving_) g.patches[wall.patch].shape = wall.atStart->shifted(time_ * wall.velocity);
}

}
