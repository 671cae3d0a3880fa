/// Which particles of time folders lie in walls, and what meshToGhost prints of them.
#pragma once
#include "Cloud.hpp"
#include "Geometry.hpp"
#include "SolidOfFile.hpp"
#include <functional>

struct Solid
{
    std::string wall;
    std::function<bool(const sph::Vector<3>&)> contains;
};

/// With its periodic copies.
Solid solidOfFile(const std::string& wall, sph::SolidOfFile, const sph::Geometry&);
/// Of all walls that are no meshes, by their own distances.
std::vector<Solid> solidsOfShapes(const sph::Geometry&);

/// A line a time, a column a wall; where the first ones are; their number.
std::string reportInSolids(const std::vector<sph::Cloud>&, const std::vector<Solid>&);
