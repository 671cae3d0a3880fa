#include "verification/CapillaryBridge.hpp"
#include "base/CaseError.hpp"
#include "verification/rungeKutta.hpp"
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace sph
{

namespace
{
using std::numbers::pi;
}

CapillaryBridge::CapillaryBridge(int dimension, double radius, double gap, double volume, double contactAngle)
    : dimension_(dimension), radius_(radius), gap_(gap), theta_(contactAngle * pi / 180)
{
    if (!solve(volume))
        throw CaseError(fmt::format("no bridge of {:.4g} m^{} at {:.4g} degrees spans the gap of {:.4g} m between {} of radius {:.4g} m",
                                    volume, dimension, contactAngle, gap, dimension == 3 ? "spheres" : "cylinders", radius));
}

double CapillaryBridge::slopeAtContact(double beta) const { return pi / 2 - theta_ - beta; }
double CapillaryBridge::contactRadius(double beta) const { return radius_ * std::sin(beta); }
double CapillaryBridge::contactHeight(double beta) const { return gap_ / 2 + radius_ * (1 - std::cos(beta)); }

double CapillaryBridge::arc(double beta) const
{
    const double psi = slopeAtContact(beta);
    const double ofMeridian = std::sin(psi) / contactHeight(beta), neck = contactRadius(beta) - contactHeight(beta) * std::tan(psi / 2);
    return dimension_ == 3 ? 1 / neck - ofMeridian : -ofMeridian;
}

double CapillaryBridge::integrate(double beta, double curvature)
{
    // r and psi by z, which the meridian runs through once: |psi| < pi/2. The volume is the integral of the section.
    using State = std::array<double, 3>;
    const bool round = dimension_ == 3;
    const auto rate = [&](const State& q)
    {
        const double across = round ? std::cos(q[1]) / q[0] : 0, section = round ? pi * q[0] * q[0] : 2 * q[0];
        return State{std::tan(q[1]), (across - curvature) / std::cos(q[1]), section};
    };
    const int steps = 400;
    const double dz = -contactHeight(beta) / steps;
    State q{contactRadius(beta), slopeAtContact(beta), 0};
    for (int k = 0; k < steps; ++k) q = rungeKuttaStep(q, dz, rate);
    const double c = std::cos(beta), R = radius_;
    const double ofSolid = round ? pi * R * R * R * (2 - 3 * c + c * c * c) / 3 : R * R * (beta - std::sin(beta) * c);
    neck_ = q[0];
    volume_ = 2 * (-q[2] - ofSolid);
    return q[1];
}

bool CapillaryBridge::solve(double volume)
{
    // The arc of a circle is exact in 2-D and near in 3-D: the beta whose arc holds the volume, then Newton in beta and the curvature.
    const double upright = 0.1; // [rad] nearer to psi = -pi/2 the meridian is no function of z
    double low = 1e-3, high = pi - std::fmax(1e-3, theta_ + upright);
    const auto excess = [&](double beta)
    {
        integrate(beta, arc(beta));
        return volume_ > 0 ? volume_ - volume : -volume;
    };
    if (!(low < high && excess(high) > 0)) return false;
    for (int k = 0; k < 50; ++k)
    {
        const double middle = (low + high) / 2;
        (excess(middle) > 0 ? high : low) = middle;
    }
    beta_ = high;
    curvature_ = arc(beta_);
    for (int k = 0; k < 50; ++k)
    {
        const double slope = integrate(beta_, curvature_), V = volume_;
        if (!std::isfinite(slope + V)) return false;
        if (std::fabs(slope) < 1e-10 && std::fabs(V / volume - 1) < 1e-10) return beta_ > 0 && beta_ < pi && neck_ > 0;
        const double small = 1e-6, slope_b = (integrate(beta_ + small, curvature_) - slope) / small, V_b = (volume_ - V) / small;
        const double slope_c = (integrate(beta_, curvature_ + small / radius_) - slope) / small, V_c = (volume_ - V) / small;
        const double det = slope_b * V_c - slope_c * V_b;
        const double d_b = (-slope * V_c + slope_c * (V - volume)) / det, d_c = (-slope_b * (V - volume) + slope * V_b) / det;
        const double damping = std::fmin(1.0, 0.2 / std::fmax(std::fabs(d_b), std::fabs(d_c))); // within a fifth of a radian and of 1/R
        beta_ += damping * d_b;
        curvature_ += damping * d_c / radius_;
    }
    return false;
}

double CapillaryBridge::force() const
{
    return dimension_ == 3 ? 2 * pi * neck_ - pi * neck_ * neck_ * curvature_ : 2 - 2 * neck_ * curvature_;
}

}
