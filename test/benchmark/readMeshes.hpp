/// The time that a mesh file takes to be read.
#pragma once
#include "measure.hpp"

namespace sph
{

/// A binary STL of 10^6 facets, the file in the system's cache: the best of three.
Figures readMeshes();

}
