/// Fields of the free surface of a liquid whose gas is left out (models/gas/CompletedDensity.hpp).
#pragma once
#include "fields/fieldTags.hpp"

namespace sph
{

// clang-format off
struct SurfaceLack         { static constexpr FieldInfo info{"surfaceLack", "1"};                       template<int dim> struct At { double lack; }; };
// clang-format on

}
