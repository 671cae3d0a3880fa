/// What constant/geometry and constant/walls have in common.
#pragma once
#include "Geometry.hpp"

namespace sph
{

/// Entries `dimension` and `domain { min; max; periodic; }`.
void readSpace(const Dictionary&, Geometry&);

/// Entries contactAngle or contactAngles and velocity, and omega and origin where the wall may turn.
WallProperties readWallProperties(const Dictionary& wall, bool mayTurn);

}
