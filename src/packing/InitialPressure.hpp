/// The pressure at the start, by an expression: a fluid that is released at p = 0 and not at the pressure that it will have rings at
/// the speed of sound.
#pragma once
#include "Dictionary.hpp"
#include <functional>

namespace sph
{

using PressureField = std::function<double(const Vector<3>&)>;

/// Reads the entry `pressure "1000*9.81*(0.1 - $y)";` [Pa] of the position [m].
PressureField readPressure(const Dictionary&);

}
