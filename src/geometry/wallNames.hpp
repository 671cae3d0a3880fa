/// Names of the walls of constant/geometry, in the order of their numbers.
#pragma once
#include "geometry/Geometry.hpp"

namespace sph
{

inline std::vector<std::string> wallNames(const Geometry& geometry)
{
    std::vector<std::string> names;
    for (const auto& wall : geometry.walls) names.push_back(wall.name);
    return names;
}

}
