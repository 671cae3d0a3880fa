/// Shapes of one wall from its dictionary, as documented at readGeometry.
#pragma once
#include "Geometry.hpp"

namespace sph
{

/// The smooth surfaces of a wall within the space of `geometry` (dimension, domain, periodic directions, reach). None where an
/// entry is wrong: the mistake is then in the dictionary's Diagnostics. Spheres of a bed that are further than the reach
/// outside a domain that does not repeat are left out.
std::vector<std::shared_ptr<const Shape>> readShapes(const Dictionary& wall, const Geometry& geometry);

/// Values of `type` that name one shape, and that turn around `origin` with `omega`.
bool isSingleShape(const std::string& type);

}
