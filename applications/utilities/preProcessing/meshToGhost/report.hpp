/// What meshToGhost prints of the walls it has prepared.
#pragma once
#include "GeometryCheck.hpp"

/// One line a wall; with `full` also curvature, gaps, contacts and motion.
std::string report(const sph::Geometry&, const sph::GeometryReport&, double H, bool full);
