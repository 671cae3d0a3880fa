#include "Ritter.hpp"
#include "readDirection.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

Ritter::Ritter(double depth, double g, double rho) : depth_(depth), g_(g), rho_(rho), direction_{1, 0, 0}, up_{0, 1, 0} {}

Ritter::Ritter(const Dictionary& d)
    : depth_(d.getPositive("depth", units::m)),
      g_(d.getPositive("g", units::mPerS2, 9.81)),
      rho_(d.getPositive("rho", units::density, 1000)),
      direction_(readDirection(d, "direction", {1, 0, 0})),
      up_(readDirection(d, "up", {0, 1, 0})),
      origin_(d.get("origin", Vector<3>{}))
{
}

double Ritter::depth(double x, double t) const
{
    const double c = std::sqrt(g_ * depth_);
    if (x <= -c * t) return depth_;
    return x >= 2 * c * t ? 0 : sqr(2 * c - x / t) / (9 * g_);
}

double Ritter::speed(double x, double t) const
{
    const double c = std::sqrt(g_ * depth_);
    return x <= -c * t || x >= 2 * c * t ? 0 : 2.0 / 3 * (c + x / t);
}

double Ritter::pressure(const Vector<3>& x, double t) const
{
    const auto r = x - origin_;
    return rho_ * g_ * std::max(0.0, depth(dot(r, direction_), t) - dot(r, up_));
}

}
