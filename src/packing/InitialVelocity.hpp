/// Velocities at the start, by a named formula or by an expression.
#pragma once
#include "dictionary/EntryList.hpp"
#include <functional>

namespace sph
{

using VelocityField = std::function<Vector<3>(const Vector<3>&)>;

/// Reads the sub-dictionary `velocity`.
VelocityField readVelocity(const Dictionary&);
EntryList velocityEntries();

}
