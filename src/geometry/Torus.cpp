#include "geometry/Torus.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <numbers>

namespace sph
{

Torus::Torus(const Vector<3>& centre, const Vector<3>& axis, double ringRadius, double tubeRadius, FluidSide fluid)
    : centre_(centre), axis_(unitVector(axis)), R1_(ringRadius), R2_(tubeRadius), fluid_(fluid)
{}

Foot Torus::foot(const Vector<3>& x) const
{
    const double e = fluid_ == FluidSide::inside ? 1 : -1;
    const auto p = x - centre_;
    const double t = dot(p, axis_);
    const auto radial = p - t * axis_;
    const double rho = mag(radial);
    const bool offAxis = rho > 1e-12 * R1_;
    const auto toRing = offAxis ? radial / rho : crossSection(axis_)[0];
    const auto fromRing = (rho - R1_) * toRing + t * axis_;
    const double q = mag(fromRing);
    const bool offRing = q > 1e-12 * R2_;
    const auto outward = offRing ? fromRing / q : axis_;
    const double cosTheta = -dot(outward, toRing);
    return {e * (R2_ - q), -e * outward, e / R2_, -e * cosTheta / (R1_ - R2_ * cosTheta), offAxis && offRing};
}

Box Torus::bounds() const
{
    Box b;
    for (const auto c : coordinates)
    {
        const double half = R1_ * std::sqrt(std::max(0.0, 1 - sqr(axis_.*c))) + R2_;
        b.low.*c = centre_.*c - half;
        b.high.*c = centre_.*c + half;
    }
    return b;
}

double Torus::smallestRadius() const { return std::min(R2_, R1_ - R2_); }

std::unique_ptr<Shape> Torus::shifted(const Vector<3>& by) const { return std::make_unique<Torus>(centre_ + by, axis_, R1_, R2_, fluid_); }

ShapeDescription Torus::description() const
{
    return {"torus", {{"centre", centre_}, {"axis", axis_}}, {{"ringRadius", R1_}, {"tubeRadius", R2_}}, true, fluid_};
}

TriangleSurface Torus::triangles(const Box&, double size) const
{
    using std::numbers::pi;
    const auto [e1, e2] = crossSection(axis_);
    return parametricSurface(segments(2 * pi * (R1_ + R2_), size), segments(2 * pi * R2_, size),
                             [&, e1 = e1, e2 = e2](double u, double v)
                             {
                                 const double phi = 2 * pi * u, theta = 2 * pi * v, rho = R1_ - R2_ * std::cos(theta);
                                 return centre_ + rho * (std::cos(phi) * e1 + std::sin(phi) * e2) + R2_ * std::sin(theta) * axis_;
                             });
}

}
