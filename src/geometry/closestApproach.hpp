/// Relation of two surfaces within the domain: a gap, a contact, or a line along which they cross.
#pragma once
#include "geometry/Geometry.hpp"

namespace sph
{

struct Approach
{
    double distance = Box::infinity; ///< smallest, < 0 where they overlap [m]
    Vector<3> at;                    ///< middle of the two nearest points
    bool facing = false;             ///< the surfaces look at each other there, with fluid or solid between
    bool crossing = false;
    double wedge = 180; ///< sharpest angle of the fluid where they cross [degrees]
    /// The depth to which a ball reaches into the other solid, over its diameter; of two balls over the smaller diameter.
    double overlap = 0;
    bool same = false; ///< two balls in one place, of one radius, to a thousandth of it; exact twins are one (repeatPeriodically)
};

/// Search within the domain. `samples` are points of the surface of `a` there, `size` their distance from each other. Balls
/// (spheres, and circles in 2-D, with fluid outside) are exact; others to 1e-9 of `size`, as far as the samples find the right
/// valley.
Approach closestApproach(const Shape& a, const Shape& b, const Geometry&, const TriangleSurface& samples, double size);

/// True where closestApproach needs no samples of a.
bool isBall(const Shape&, int dimension);

}
