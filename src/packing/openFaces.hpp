/// Faces of the domain that no wall closes, where a scene goes on or ends: through openings, or at the lid that a tank does not have.
#pragma once
#include "Geometry.hpp"

namespace sph
{

/// The geometry with a plane in each face of the domain that is neither periodic nor closed by walls, for a relaxation: it mirrors what stands before it. Without it the
/// face is a free surface, over which the pressure that particles share spreads them: a pipe between two openings lost 6 % of its density in 200 steps.
/// A face counts as open where the fluid lies further than half of `spacing` [m] from any wall somewhere on it; layers are made anew where
/// walls are layers, for a kernel of the support `H` [m].
Geometry withOpenFacesClosed(const Geometry&, double H, double spacing);

}
