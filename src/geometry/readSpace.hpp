/// Entries that constant/geometry and constant/walls share.
#pragma once
#include "geometry/Geometry.hpp"

namespace sph
{

/// Entries `dimension` and `domain { min; max; periodic; }`.
void readSpace(const Dictionary&, Geometry&);

/// Throws CaseError, with every mistake found until then, where particles of this resolution do not fit the domain: a direction that repeats must
/// be longer than the kernel's support and a spacing, or a particle would be its own neighbour; no direction may be shorter than a spacing; and
/// there must not be room for more particles than can be counted. The one check of all programs, asked before walls are repeated: a spacing
/// that is too large would make copies without end.
void checkFit(const Geometry&, const Resolution&, Diagnostics&);

/// Entries contactAngle or contactAngles and velocity, and omega and origin where the wall may turn.
WallProperties readWallProperties(const Dictionary& wall, int dimension, bool mayTurn);
/// Entry `load { force; direction; mass; damping; }` of a wall that is no mesh.
void readLoad(const Dictionary& wall, WallProperties&, int dimension);

}
