/// Angles below which facets of a mesh count as the same.
#pragma once
#include <numbers>

namespace sph
{

inline constexpr double degree = std::numbers::pi / 180;
/// Neighbours that turn by less are one plane; binary STL has seven digits.
inline constexpr double flatAngle = 0.05 * degree;

}
