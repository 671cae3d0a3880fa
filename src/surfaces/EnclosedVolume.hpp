/// The volume that a surface on a regular grid encloses, and in how many pieces.
#pragma once
#include "surfaces/RegularGrid.hpp"
#include <functional>
#include <vector>

namespace sph
{

struct Enclosed
{
    double volume = 0; ///< area in 2-D
    int pieces = 0;    ///< connected through periodic faces, too
};

/// The region colour > iso outside solids. Each cell is cut into 6 tetrahedra (2 triangles), in which both functions are linear
/// and the region a polyhedron: the error is of second order in the step, at walls and at their contact with the surface as well.
/// A piece is a set of nodes of the region that are neighbours along the grid.
Enclosed enclosedVolume(const RegularGrid&, const std::vector<double>& colour, double iso, const std::vector<double>& wallDistance);

/// The level between 0.01 and 0.99 at which the surface encloses `volume`, to 1e-4 of the level: the surface of half colour is rounded, and thin
/// bodies lose by it. The end of that range which comes nearest where there is none.
double levelEnclosing(double volume, const std::function<double(double level)>& enclosed);

}
