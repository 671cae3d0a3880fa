/// The contact angle of a wall as a drop sees it.
#pragma once
#include "dictionary/EntryList.hpp"
#include "geometry/Geometry.hpp"
#include <limits>

namespace sph
{

namespace entry
{
const Scalar angle{"angle", degrees, byScene("the wall's of two phases, turned round for the second"),
                   between(0, 180).saying("a contact angle lies between 0 and 180 degrees"), "the exact one"};
}

/// Through phase number `phase`, of that name, with `around` beside it [degrees]; NaN where the wall says nothing of the two.
inline double wallAngle(const WallProperties& wall, std::size_t phase, const std::string& name, const std::string& around)
{
    if (wall.contactAngles.empty()) return phase == 0 ? wall.contactAngle : 180 - wall.contactAngle;
    return wall.angleOf(name, around).value_or(std::numeric_limits<double>::quiet_NaN());
}

}
