/// Distance of a point from a closed surface, and whether it lies inside.
#pragma once
#include "solids/Bed.hpp"

namespace sph
{

double distanceToTriangle(const Vector<3>& p, const Vector<3>& a, const Vector<3>& b, const Vector<3>& c);
double distanceToSurface(const TriangleSurface&, const Vector<3>&);
/// Whether the point lies inside, by the number of facets above it.
bool isInside(const TriangleSurface&, const Vector<3>&);

}
