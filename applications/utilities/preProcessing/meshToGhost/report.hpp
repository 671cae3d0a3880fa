/// What meshToGhost prints of the walls it has prepared.
#pragma once
#include "geometry/GeometryCheck.hpp"
#include <string>
#include <vector>

using Row = std::vector<std::string>;

/// Columns as wide as their widest entry.
std::string table(const std::vector<Row>&);

/// One line a wall; with `full` also curvature, gaps, contacts and motion.
std::string report(const sph::Geometry&, const sph::GeometryReport&, double H, bool full);
