#include "models/openings/OpenPlanes.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{
std::vector<Opening> openingsOf(const Case& theCase, const Geometry& geometry, double spacing, const std::vector<std::string>& phases)
{
    Coefficients c;
    c.dimension = geometry.dimension;
    c.spacing = spacing;
    c.phases = phases;
    return readOpeningPlanes(theCase, geometry, c);
}
}

bool inSight(const Opening& opening, const Geometry& geometry, const Vector<3>& x, double spacing)
{
    const double s = opening.distance(x);
    if (s > 0 || !opening.opensAt(x - s * opening.normal, geometry.dimension, opening.margin)) return false;
    for (double by = 0; by < -s; by += spacing)
        if (!geometry.inFluid(x + by * opening.normal)) return false;
    return true;
}

OpenPlanes::OpenPlanes(const Case& theCase, const Geometry& geometry, const Resolution& resolution, const std::vector<std::string>& phases)
    : openings_(openingsOf(theCase, geometry, resolution.spacing, phases)),
      geometry_(geometry),
      spacing_(resolution.spacing),
      depth_(2 * resolution.H() + resolution.spacing)
{}

double OpenPlanes::distance(const Vector<3>& x) const
{
    double nearest = Box::infinity;
    for (const auto& opening : openings_)
    {
        const double s = opening.distance(x);
        if (!opening.opensAt(x - s * opening.normal, geometry_.dimension, opening.margin)) continue;
        if (s >= 0 || s > -depth_ || inSight(opening, geometry_, x, spacing_)) nearest = std::min(nearest, s);
    }
    return nearest;
}

}
