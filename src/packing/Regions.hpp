/// Regions of space by name, and their unions, intersections and differences.
#pragma once
#include "Dictionary.hpp"
#include "Geometry.hpp"
#include <functional>

namespace sph
{

using Region = std::function<bool(const Vector<3>&)>;

/// Reads `region <type>;` and what belongs to it from an entry of `fill`:
///
///     all                                                              none
///     sphere       centre, radius          (periodic copies included; a circle in 2-D)
///     box          min, max                (min <= x < max: boxes side by side share no particle; z is not looked at in 2-D)
///     halfSpace    point, normal           (the side that the normal points to)
///     cylinder     centre, axis, radius, length (optional: half of it to either side of the centre)
///     union, intersection, difference      of ( {..} {..} )    (difference: the first without the others)
Region readRegion(const Dictionary&, const Geometry&);

const std::vector<std::string>& regionNames();

}
