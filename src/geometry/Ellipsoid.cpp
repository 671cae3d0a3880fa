#include "geometry/Ellipsoid.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

namespace sph
{

namespace
{

std::array<double, 3> asArray(const Vector<3>& a) { return {a.x, a.y, a.z}; }

constexpr Vector<3> product(const Vector<3>& a, const Vector<3>& b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }

}

Ellipsoid::Ellipsoid(const Vector<3>& centre, const Vector<3>& semiAxes, FluidSide fluid)
    : centre_(centre),
      semiAxes_(semiAxes),
      weight_{1 / sqr(semiAxes.x), 1 / sqr(semiAxes.y), 1 / sqr(semiAxes.z)},
      least_(Box::infinity),
      largest_(0),
      fluid_(fluid)
{
    for (const double a : asArray(semiAxes))
        if (std::isfinite(a))
        {
            least_ = std::min(least_, a);
            largest_ = std::max(largest_, a);
        }
}

Ellipsoid::Nearest Ellipsoid::nearest(const Vector<3>& point) const
{
    const auto a = asArray(semiAxes_), w = asArray(weight_), x = asArray(point);
    std::array<double, 3> g{}, p{}; // p_i = x_i/(g_i + tau w_i)
    double tau = 0;
    for (int i = 0; i < 3; ++i)
    {
        g[i] = a[i] == least_ ? 0 : 1 - sqr(least_) * w[i];
        if (w[i] > 0) tau = std::max(tau, a[i] * std::abs(x[i]) - (a[i] - least_) * (a[i] + least_));
    }

    double sum = 0, slope = 0;
    const auto evaluate = [&]
    {
        sum = slope = 0;
        for (int i = 0; i < 3; ++i)
        {
            if (x[i] == 0 || w[i] == 0) continue;
            const double denominator = g[i] + tau * w[i], term = w[i] * sqr(x[i] / denominator);
            sum += term;
            slope += term * w[i] / denominator; // -sum'/2
        }
    };
    evaluate();
    const bool unique = sum >= 1;
    // Fewer than 1 only at tau = 0, where no point on the short axes has a foot: they come in by symmetry.
    for (int iteration = 0; unique && iteration < 50; ++iteration)
    {
        const double root = std::sqrt(sum), step = (root - 1) * sum / slope;
        tau += step;
        if (!(step > 2 * std::numeric_limits<double>::epsilon() * tau)) break;
        evaluate();
    }
    bool rest = !unique;
    for (int i = 0; i < 3; ++i)
    {
        const double denominator = g[i] + tau * w[i];
        if (x[i] != 0) p[i] = x[i] / denominator;
        else if (rest && a[i] == least_)
        {
            p[i] = least_ * std::sqrt(1 - sum);
            rest = false;
        }
    }
    return {{p[0], p[1], p[2]}, unique};
}

Foot Ellipsoid::foot(const Vector<3>& x) const
{
    const double e = fluid_ == FluidSide::inside ? 1 : -1;
    const auto relative = x - centre_;
    const auto [p, unique] = nearest(relative);
    const auto gradient = product(weight_, p);
    const double length = mag(gradient);
    const auto outward = gradient / length;
    const auto [e1, e2] = crossSection(outward);
    const double k11 = dot(e1, product(weight_, e1)) / length, k12 = dot(e1, product(weight_, e2)) / length,
                 k22 = dot(e2, product(weight_, e2)) / length;
    const double mean = 0.5 * (k11 + k22), difference = std::hypot(0.5 * (k11 - k22), k12);
    return {e * dot(p - relative, outward), -e * outward, e * (mean + difference), e * (mean - difference), unique};
}

Box Ellipsoid::bounds() const { return {centre_ - semiAxes_, centre_ + semiAxes_}; }

std::unique_ptr<Shape> Ellipsoid::shifted(const Vector<3>& by) const
{
    return std::make_unique<Ellipsoid>(centre_ + by, semiAxes_, fluid_);
}

ShapeDescription Ellipsoid::description() const { return {"ellipsoid", {{"centre", centre_}, {"semiAxes", semiAxes_}}, {}, true, fluid_}; }

bool Ellipsoid::invariantAlong(int direction) const { return std::isinf(semiAxes_.*component(direction)); }

TriangleSurface Ellipsoid::triangles(const Box& within, double size) const
{
    using std::numbers::pi;
    const int round = segments(2 * pi * largest_, size);
    if (std::isinf(semiAxes_.z))
        return parametricSurface(round, segments(within.high.z - within.low.z, size),
                                 [&](double u, double v)
                                 {
                                     const double phi = 2 * pi * u;
                                     return Vector<3>{centre_.x + semiAxes_.x * std::cos(phi), centre_.y + semiAxes_.y * std::sin(phi),
                                                      within.low.z + v * (within.high.z - within.low.z)};
                                 });
    return parametricSurface(
        round, segments(pi * largest_, size),
        [&](double u, double v)
        {
            const double phi = 2 * pi * u, theta = pi * v;
            return centre_ + product(semiAxes_, {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
        });
}

}
