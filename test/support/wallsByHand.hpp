/// Walls made by hand.
#pragma once
#include "geometry/Cylinder.hpp"
#include "geometry/Geometry.hpp"
#include "geometry/Plane.hpp"
#include "geometry/SolidBox.hpp"
#include "geometry/Sphere.hpp"

namespace sph::test
{

inline Geometry domain(int dimension, Vector<3> high, std::array<bool, 3> periodic = {})
{
    Geometry g;
    g.dimension = dimension;
    g.high = high;
    g.periodic = periodic;
    return g;
}

/// Each shape a wall of its own. repeatPeriodically is the caller's last word.
inline void addWall(Geometry& g, const Shape& shape)
{
    g.originals.push_back({std::shared_ptr<const Shape>(shape.shifted({})), int(g.walls.size())});
    WallProperties wall;
    wall.name = "wall" + std::to_string(g.walls.size());
    g.walls.push_back(wall);
}

/// A tank in 2-D whose floor bears a block, with its periodic copies.
inline Geometry tankWithBlock()
{
    Geometry g = domain(2, {1, 1, 1});
    for (const auto& [at, n] : {std::pair{Vector<3>{0, 0, 0}, Vector<3>{1, 0, 0}},
                                {Vector<3>{1, 0, 0}, Vector<3>{-1, 0, 0}},
                                {Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}}})
        addWall(g, Plane(at, n));
    addWall(g, SolidBox({0.4, 0, -Box::infinity}, {0.6, 0.3, Box::infinity}));
    repeatPeriodically(g, 0.2);
    return g;
}

}
