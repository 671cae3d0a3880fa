/// Coordinates by number, for set-up code that treats x, y and z alike; inner loops name them.
#pragma once
#include "base/Vector.hpp"

namespace sph
{

inline constexpr double Vector<3>::*coordinates[]{&Vector<3>::x, &Vector<3>::y, &Vector<3>::z};
inline constexpr char coordinateNames[]{'x', 'y', 'z'};

constexpr double Vector<3>::*component(int direction) { return coordinates[direction]; }

}
