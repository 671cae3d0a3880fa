#include "geometry/Plane.hpp"
#include "geometry/components.hpp"
#include <algorithm>

namespace sph
{

Plane::Plane(const Vector<3>& point, const Vector<3>& normal) : point_(point), normal_(unitVector(normal)) {}

Box Plane::bounds() const
{
    Box b;
    for (const auto c : coordinates)
        if (std::abs(normal_.*c) == 1) b.low.*c = b.high.*c = point_.*c;
    return b;
}

std::unique_ptr<Shape> Plane::shifted(const Vector<3>& by) const { return std::make_unique<Plane>(point_ + by, normal_); }

ShapeDescription Plane::description() const { return {"plane", {{"point", point_}, {"normal", normal_}}, {}, false, {}}; }

bool Plane::invariantAlong(int direction) const { return std::abs(normal_.*component(direction)) < 1e-12; }

TriangleSurface Plane::triangles(const Box& within, double size) const
{
    const auto [e1, e2] = crossSection(normal_);
    double low1 = Box::infinity, low2 = low1, high1 = -low1, high2 = high1;
    for (const auto& corner : corners(within))
    {
        const double s1 = dot(corner - point_, e1), s2 = dot(corner - point_, e2);
        low1 = std::min(low1, s1);
        high1 = std::max(high1, s1);
        low2 = std::min(low2, s2);
        high2 = std::max(high2, s2);
    }
    return parametricSurface(segments(high1 - low1, size), segments(high2 - low2, size),
                             [&, e1 = e1, e2 = e2](double u, double v)
                             { return point_ + (low1 + u * (high1 - low1)) * e1 + (low2 + v * (high2 - low2)) * e2; });
}

}
