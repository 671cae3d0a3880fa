/// The table that reconstructSurface writes.
#pragma once
#include "base/Column.hpp"

namespace sph
{

/// surfaces.dat, in the order of SurfaceReport's numbers for each phase.
TableInfo surfaceTable(int dimension = 3);

}
