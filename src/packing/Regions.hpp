/// Regions of space by name, and their unions, intersections and differences.
#pragma once
#include "EntryList.hpp"
#include "Geometry.hpp"
#include <functional>

namespace sph
{

using Region = std::function<bool(const Vector<3>&)>;

/// Reads `region <type>;` and what belongs to it from an entry of `fill`.
Region readRegion(const Dictionary&, const Geometry&);

EntryList regionEntries();

}
