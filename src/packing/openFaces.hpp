/// Planes that close what a relaxation must not spread beyond: each mirrors what stands before it. Without them an open face is a free surface, over
/// which the pressure that particles share spreads them: a pipe between two openings lost 6 % of its density in 200 steps.
#pragma once
#include "geometry/Geometry.hpp"
#include <vector>

namespace sph
{

struct ClosingPlane
{
    Vector<3> point, normal; ///< [m]; unit, towards what is kept
};

/// The geometry with these planes as one more wall.
Geometry closedBy(const std::vector<ClosingPlane>&, const Geometry&);

/// The faces of the domain that are neither periodic nor closed by walls, where a scene goes on or ends: through openings, or at the lid that a tank does not
/// have. A face counts as open where the fluid lies further than half of `spacing` [m] from any wall somewhere on it.
std::vector<ClosingPlane> openFaces(const Geometry&, double spacing);

}
