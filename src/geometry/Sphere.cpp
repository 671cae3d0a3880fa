#include "geometry/Sphere.hpp"
#include <algorithm>
#include <numbers>

namespace sph
{

Sphere::Sphere(const Vector<3>& centre, double radius, FluidSide fluid) : centre_(centre), R_(radius), fluid_(fluid) {}

Foot Sphere::foot(const Vector<3>& x) const
{
    const auto q = x - centre_;
    const double r = mag(q), e = fluid_ == FluidSide::inside ? 1 : -1;
    const bool smooth = r > 1e-12 * R_;
    return {e * (R_ - r), smooth ? -e / r * q : Vector<3>{-e, 0, 0}, e / R_, e / R_, smooth};
}

Box Sphere::bounds() const
{
    const Vector<3> R{R_, R_, R_};
    return {centre_ - R, centre_ + R};
}

std::unique_ptr<Shape> Sphere::shifted(const Vector<3>& by) const { return std::make_unique<Sphere>(centre_ + by, R_, fluid_); }

ShapeDescription Sphere::description() const { return {"sphere", {{"centre", centre_}}, {{"radius", R_}}, true, fluid_}; }

double Sphere::distanceTo(const Box& box) const
{
    const Vector<3> nearest{std::clamp(centre_.x, box.low.x, box.high.x), std::clamp(centre_.y, box.low.y, box.high.y),
                            std::clamp(centre_.z, box.low.z, box.high.z)};
    return std::max(0.0, mag(nearest - centre_) - R_);
}

TriangleSurface Sphere::triangles(const Box&, double size) const
{
    using std::numbers::pi;
    return parametricSurface(
        segments(2 * pi * R_, size), segments(pi * R_, size),
        [&](double u, double v)
        {
            const double phi = 2 * pi * u, theta = pi * v;
            return centre_ + R_ * Vector<3>{std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
        });
}

}
