#include "geometry/OpenEnds.hpp"
#include <algorithm>

namespace sph
{

OpenEnds::OpenEnds(const Case& theCase, const Geometry& geometry, const Resolution& resolution)
    : geometry_(geometry), spacing_(resolution.spacing), depth_(2 * resolution.H() + resolution.spacing)
{
    for (const auto& d : openingDictionaries(theCase.dictionaryIfPresent("constant/openings")))
        for (auto& plane : readOpenPlanes(d, geometry, spacing_)) planes_.push_back(std::move(plane));
    cutOutParts(planes_, spacing_);
}

std::pair<const OpenPlane*, double> OpenEnds::nearest(const Vector<3>& x) const
{
    std::pair<const OpenPlane*, double> nearest{nullptr, Box::infinity};
    for (const auto& plane : planes_)
        if (const double s = plane.distance(x); s > -depth_ ? plane.faces(x, geometry_.dimension) : plane.inSight(geometry_, x, spacing_))
            if (s < nearest.second) nearest = {&plane, s};
    return nearest;
}

}
