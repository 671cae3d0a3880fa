/// The pressure at the start, by an expression: a fluid that is released at p = 0 and not at the pressure that it will have rings at
/// the speed of sound.
#pragma once
#include "dictionary/EntryList.hpp"
#include <functional>

namespace sph
{

using PressureField = std::function<double(const Vector<3>&)>;

namespace entry
{
const Text pressure{"pressure", byScene("that of the positions"),
                    "at the start [Pa], \"1000*9.81*(0.1 - $y)\", above the background pressure; $x, $y, $z are the position [m]"};
}

PressureField readPressure(const Dictionary&);

}
