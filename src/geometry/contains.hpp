/// Boxes that hold a point, edges included; z counts in 3-D alone.
#pragma once
#include "geometry/Shape.hpp"

namespace sph
{

inline bool contains(const Box& box, const Vector<3>& x, int dimension)
{
    const auto between = [](double low, double q, double high) { return q >= low && q <= high; };
    return between(box.low.x, x.x, box.high.x) && between(box.low.y, x.y, box.high.y) &&
           (dimension == 2 || between(box.low.z, x.z, box.high.z));
}

}
