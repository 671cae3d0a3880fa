/// Where a point is to a closed surface.
#pragma once
#include "Bed.hpp"

namespace sph
{

double distanceToTriangle(const Vector<3>& p, const Vector<3>& a, const Vector<3>& b, const Vector<3>& c);
double distanceToSurface(const TriangleSurface&, const Vector<3>&);
/// By the number of facets above the point.
bool isInside(const TriangleSurface&, const Vector<3>&);

}
