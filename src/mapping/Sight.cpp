#include "mapping/Sight.hpp"
#include "geometry/components.hpp"
#include <cmath>
#include <limits>

namespace sph
{

double Sight::toWall(Vector<3> x) const
{
    if (geometry_.patches.empty()) return std::numeric_limits<double>::infinity();
    for (int k = 0; k < geometry_.dimension; ++k)
        if (geometry_.periodic[std::size_t(k)])
        {
            auto& a = x.*component(k);
            const double low = geometry_.low.*component(k), period = geometry_.length(k);
            a -= period * std::floor((a - low) / period);
        }
    return geometry_.distance(x);
}

bool Sight::isFree(const PlacedPoint& a, const PlacedPoint& b) const
{
    const auto way = b.x - a.x;
    const double length = mag(way), fromA = std::max(a.toWall, 0.0), fromB = std::max(b.toWall, 0.0);
    const double open = length - fromA - fromB;
    if (open <= finest_) return true;
    const auto x = a.x + ((fromA + 0.5 * open) / length) * way;
    const PlacedPoint middle{x, toWall(x)};
    return middle.toWall > -tolerance_ && isFree(a, middle) && isFree(middle, b);
}

}
