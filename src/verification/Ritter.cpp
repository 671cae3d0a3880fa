#include "verification/Ritter.hpp"
#include "sampling/sharedEntries.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace entry
{
const Scalar damDepth{"depth", units::m, required, positive, "of the reservoir before the dam is gone"},
    damG{"g", units::mPerS2, 9.81, positive, "gravity"}, rho{"rho", units::density, 1000, positive, "density"};
const Direction up{"up", Vector<3>{0, 1, 0}, "against gravity"};
}

Ritter::Ritter(double depth, double g, double rho) : depth_(depth), g_(g), rho_(rho), direction_{1, 0, 0}, up_{0, 1, 0} {}

Ritter::Ritter(const Dictionary& d)
    : depth_(entry::damDepth(d)),
      g_(entry::damG(d)),
      rho_(entry::rho(d)),
      direction_(entry::direction(d)),
      up_(entry::up(d)),
      origin_(entry::origin(d))
{}

EntryList Ritter::entries() { return {entry::damDepth, entry::damG, entry::rho, entry::direction, entry::up, entry::origin}; }

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
