#include "geometry/MovingWalls.hpp"
#include "geometry/Plane.hpp"
#include "geometry/TriangleMesh.hpp"
#include "geometry/components.hpp"

namespace sph
{

namespace
{
constexpr const char* wallTime = "wallTime";

/// "wallVelocity(plate)" of a wall under load, along its direction.
std::string numberOf(const char* of, const WallProperties& wall) { return std::string(of) + '(' + wall.name + ')'; }
constexpr const char *velocityOf = "wallVelocity", *displacementOf = "wallDisplacement";
}

bool movesAcross(const Geometry& g, const Patch& patch)
{
    const auto& wall = g.walls[std::size_t(patch.wall)];
    if (!(wall.omega == Vector<3>{}) || dynamic_cast<const TriangleMesh*>(patch.shape.get())) return false;
    const auto& v = wall.heading();
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
        moving_.push_back({p, patch.shape, patch.wall});
        if (g.walls[std::size_t(patch.wall)].load) displacement_[patch.wall] = {};
    }
    if (!any()) return;
    findFastest(g);
    g.grid.reset();
    g.tree.reset();
}

void MovingWalls::findFastest(const Geometry& g)
{
    fastest_ = 0;
    for (const auto& moving : moving_) fastest_ = std::max(fastest_, mag(g.walls[std::size_t(moving.wall)].velocity));
}

double MovingWalls::speedAlong(const Geometry& g, int patch, const Vector<3>& n) const
{
    for (const auto& moving : moving_)
        if (int(moving.patch) == patch) return dot(n, g.walls[std::size_t(moving.wall)].velocity);
    return 0;
}

void MovingWalls::push(Geometry& g, int wall, const Vector<3>& velocity)
{
    g.walls[std::size_t(wall)].velocity = velocity;
    findFastest(g);
}

void MovingWalls::advance(Geometry& g, double deltaT)
{
    time_ += deltaT;
    travelled_ += deltaT * fastest_;
    for (auto& [wall, displacement] : displacement_) displacement += deltaT * g.walls[std::size_t(wall)].velocity;
    place(g);
}

void MovingWalls::place(Geometry& g) const
{
    for (const auto& [patch, atStart, wall] : moving_)
    {
        const auto underLoad = displacement_.find(wall);
        g.patches[patch].shape =
            atStart->shifted(underLoad != displacement_.end() ? underLoad->second : time_ * g.walls[std::size_t(wall)].velocity);
    }
}

void MovingWalls::save(const Geometry& g, std::map<std::string, double>& numbers) const
{
    if (any()) numbers[wallTime] = time_;
    for (const auto& [w, displacement] : displacement_)
    {
        const auto& wall = g.walls[std::size_t(w)];
        numbers[numberOf(velocityOf, wall)] = dot(wall.velocity, wall.load->direction);
        numbers[numberOf(displacementOf, wall)] = dot(displacement, wall.load->direction);
    }
}

void MovingWalls::restore(Geometry& g, const std::map<std::string, double>& numbers)
{
    if (!any() || numbers.empty()) return;
    const auto number = [&](const std::string& name)
    {
        const auto found = numbers.find(name);
        return found == numbers.end() ? 0 : found->second;
    };
    time_ = number(wallTime);
    for (auto& [w, displacement] : displacement_)
    {
        auto& wall = g.walls[std::size_t(w)];
        wall.velocity = number(numberOf(velocityOf, wall)) * wall.load->direction;
        displacement = number(numberOf(displacementOf, wall)) * wall.load->direction;
    }
    findFastest(g);
    place(g);
}

}
