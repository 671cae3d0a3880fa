/// Velocities at the start, by a named formula or by an expression.
#pragma once
#include "Dictionary.hpp"
#include <functional>
#include <string>
#include <vector>

namespace sph
{

using VelocityField = std::function<Vector<3>(const Vector<3>&)>;

/// Reads the sub-dictionary `velocity`:
///
///     uniform       value (1 0 0);
///     taylorGreen   U, L:  u = U sin(kx) cos(ky), v = -U cos(kx) sin(ky), k = 2 pi/L (Taylor & Green 1937)
///     rotation      omega (0 0 1); origin (0 0 0);     u = omega x (x - origin)
///     couette       U; height; direction (1 0 0); normal (0 1 0); origin (0 0 0);  from 0 at the origin to U at the height
///     poiseuille    U; height; direction; normal; origin;         4 U s (1 - s), s the height above the origin in heights
///     expression    U "vector(sin(2*pi()*$x), 0, 0)";             $x, $y, $z are the position [m]
VelocityField readVelocity(const Dictionary&);

const std::vector<std::string>& velocityNames();

}
