#include "geometry/Shape.hpp"
#include <algorithm>

namespace sph
{

double Shape::distanceTo(const Box& box) const
{
    const auto own = bounds();
    const auto gap = [](double lowA, double highA, double lowB, double highB) { return std::max({0.0, lowA - highB, lowB - highA}); };
    return mag(Vector<3>{gap(own.low.x, own.high.x, box.low.x, box.high.x), gap(own.low.y, own.high.y, box.low.y, box.high.y),
                         gap(own.low.z, own.high.z, box.low.z, box.high.z)});
}

TriangleSurface triangulate(const Shape& shape, const Box& within, double size)
{
    auto surface = cropped(shape.triangles(within, size), within);
    for (auto& [a, b, c] : surface.triangles)
    {
        const auto &p = surface.points[a], &q = surface.points[b], &r = surface.points[c];
        if (dot(cross(q - p, r - p), shape.foot((p + q + r) / 3).normal) < 0) std::swap(b, c);
    }
    return surface;
}

}
