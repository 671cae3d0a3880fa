#include "geometry/Cylinder.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <numbers>

namespace sph
{

Cylinder::Cylinder(const Vector<3>& point, const Vector<3>& axis, double radius, FluidSide fluid)
    : point_(point), axis_(unitVector(axis)), R_(radius), fluid_(fluid)
{}

Foot Cylinder::foot(const Vector<3>& x) const
{
    auto q = x - point_;
    q -= dot(q, axis_) * axis_;
    const double r = mag(q), e = fluid_ == FluidSide::inside ? 1 : -1;
    const bool smooth = r > 1e-12 * R_;
    return {e * (R_ - r), smooth ? -e / r * q : -e * crossSection(axis_)[0], e / R_, 0, smooth};
}

Box Cylinder::bounds() const
{
    Box b;
    for (const auto c : coordinates)
        if (axis_.*c == 0)
        {
            b.low.*c = point_.*c - R_;
            b.high.*c = point_.*c + R_;
        }
    return b;
}

std::unique_ptr<Shape> Cylinder::shifted(const Vector<3>& by) const { return std::make_unique<Cylinder>(point_ + by, axis_, R_, fluid_); }

ShapeDescription Cylinder::description() const
{
    return {"cylinder", {{"point", point_}, {"axis", axis_}}, {{"radius", R_}}, true, fluid_};
}

bool Cylinder::invariantAlong(int direction) const { return std::abs(axis_.*component(direction)) > 1 - 1e-12; }

TriangleSurface Cylinder::triangles(const Box& within, double size) const
{
    using std::numbers::pi;
    const auto [e1, e2] = crossSection(axis_);
    double low = Box::infinity, high = -low;
    for (const auto& corner : corners(within))
    {
        low = std::min(low, dot(corner - point_, axis_));
        high = std::max(high, dot(corner - point_, axis_));
    }
    return parametricSurface(segments(2 * pi * R_, size), segments(high - low, size),
                             [&, e1 = e1, e2 = e2](double u, double v)
                             {
                                 const double phi = 2 * pi * u;
                                 return point_ + (low + v * (high - low)) * axis_ + R_ * (std::cos(phi) * e1 + std::sin(phi) * e2);
                             });
}

}
