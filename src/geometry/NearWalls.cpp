#include "geometry/NearWalls.hpp"

namespace sph
{

NearestFoot NearWalls::nearestFoot(const Vector<3>& x, double reach) const
{
    NearestFoot nearest;
    nearest.foot.distance = Box::infinity;
    for (const int p : patches(x))
        if (const Foot foot = geometry_->foot(p, x); foot.exposure > 0 && foot.distance <= reach && foot.distance < nearest.foot.distance)
            nearest = {foot, p};
    return nearest;
}

}
