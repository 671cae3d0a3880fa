#include "geometry/Cone.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <numbers>

namespace sph
{

using std::numbers::pi;

Cone::Cone(const Vector<3>& apex, const Vector<3>& axis, double halfAngle, FluidSide fluid)
    : apex_(apex),
      axis_(unitVector(axis)),
      halfAngle_(halfAngle),
      sine_(std::sin(halfAngle * pi / 180)),
      cosine_(std::cos(halfAngle * pi / 180)),
      fluid_(fluid)
{}

Foot Cone::foot(const Vector<3>& x) const
{
    const double e = fluid_ == FluidSide::inside ? 1 : -1;
    const auto q = x - apex_;
    const double t = dot(q, axis_);
    const auto radial = q - t * axis_;
    const double rho = mag(radial), s = t * cosine_ + rho * sine_;
    if (s <= 0)
    {
        // The nearest place is the apex, behind which the point lies outside the cone.
        const double r = mag(q);
        return {-e * r, r > 0 ? -e / r * q : e * axis_, 0, 0, false};
    }
    const bool smooth = rho > 1e-12 * s;
    const auto outward = smooth ? radial / rho : crossSection(axis_)[0];
    return {e * (t * sine_ - rho * cosine_), e * (sine_ * axis_ - cosine_ * outward), e * cosine_ / (s * sine_), 0, smooth};
}

Box Cone::bounds() const
{
    // Finite only behind the apex, and there only if no generator points backwards.
    Box b;
    for (const auto c : coordinates)
    {
        const double along = axis_.*c * cosine_, across = std::sqrt(std::max(0.0, 1 - sqr(axis_.*c))) * sine_;
        if (along >= across) b.low.*c = apex_.*c;
        if (-along >= across) b.high.*c = apex_.*c;
    }
    return b;
}

std::unique_ptr<Shape> Cone::shifted(const Vector<3>& by) const { return std::make_unique<Cone>(apex_ + by, axis_, halfAngle_, fluid_); }

ShapeDescription Cone::description() const
{
    return {"cone", {{"apex", apex_}, {"axis", axis_}}, {{"halfAngle", halfAngle_}}, true, fluid_};
}

TriangleSurface Cone::triangles(const Box& within, double size) const
{
    const auto [e1, e2] = crossSection(axis_);
    double low = Box::infinity, high = 0;
    for (const auto& corner : corners(within))
    {
        low = std::min(low, dot(corner - apex_, axis_));
        high = std::max(high, dot(corner - apex_, axis_));
    }
    low = std::max(0.0, low);
    if (high <= low) return {};
    const double widest = high * sine_ / cosine_;
    return parametricSurface(segments(2 * pi * widest, size), segments((high - low) / cosine_, size),
                             [&, e1 = e1, e2 = e2](double u, double v)
                             {
                                 const double phi = 2 * pi * u, t = low + v * (high - low);
                                 return apex_ + t * axis_ + (t * sine_ / cosine_) * (std::cos(phi) * e1 + std::sin(phi) * e2);
                             });
}

}
