/// The space that the walls leave to the fluid: its extent, its volume and the spheres that it goes round.
#pragma once
#include "geometry/Geometry.hpp"
#include <optional>
#include <vector>

namespace sph
{

/// The domain, cut back to the plane walls that are normal to an axis and cross it from side to side.
Box fluidBox(const Geometry&);

struct Ball
{
    Vector<3> centre;
    double radius;
};

/// The sphere (in 2-D the circle) with fluid outside that a shape is, if it is one.
std::optional<Ball> asBall(const Shape&, int dimension);

/// The balls among the patches, each once: periodic copies are left out.
std::vector<Ball> ballsInCell(const Geometry&);

struct FluidVolume
{
    double value = 0; ///< [m^3]; [m^2] in 2-D
    double error = 0; ///< estimate, 0 where exact
    bool exact = false;
};

/// Exact for a box without other walls, and for a box around balls that overlap neither each other nor a wall. Otherwise by
/// cells halved where a wall crosses them, down to `finest` [m], each cut by the tangent plane corrected for curvature; the
/// error is the difference to cells of twice that size.
FluidVolume fluidVolume(const Geometry&, double finest);

}
