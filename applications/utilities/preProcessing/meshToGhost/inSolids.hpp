/// Particles of time folders that lie in walls, and the text that meshToGhost prints of them.
#pragma once
#include "case/Cloud.hpp"
#include "geometry/Geometry.hpp"
#include "meshes/SolidOfFile.hpp"
#include <functional>

struct Solid
{
    std::string wall;
    std::function<bool(const sph::Vector<3>&)> contains;
};

/// The solid of a file, with its periodic copies.
Solid solidOfFile(const std::string& wall, sph::SolidOfFile, const sph::Geometry&);
/// Solids of all walls that are no meshes, by their own distances.
std::vector<Solid> solidsOfShapes(const sph::Geometry&);

/// A line a time, a column a wall; where the first ones are; their number.
std::string reportInSolids(const std::vector<sph::Cloud>&, const std::vector<Solid>&);
