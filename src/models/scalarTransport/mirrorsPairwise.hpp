/// Whether the walls of a scene mirror from both sides of a pair alike.
#pragma once
#include "geometry/Geometry.hpp"

namespace sph
{

/// True where all walls are mirroring planes, parallel or at right angles: a particle and the ghost of another then see what the other and the ghost of the
/// first see, and ghosts with their sources' values exchange pairwise.
bool mirrorsPairwise(const Geometry&);

}
