/// A vector's component by number, for set-up code that goes through the axes; loops over particles use the names.
#pragma once
#include "Vector.hpp"

namespace sph
{

constexpr double component(const Vector<3>& a, int axis) { return axis == 0 ? a.x : axis == 1 ? a.y : a.z; }
constexpr double& component(Vector<3>& a, int axis) { return axis == 0 ? a.x : axis == 1 ? a.y : a.z; }

}
