#include "verification/SuspensionChannel.hpp"
#include "verification/flowEntries.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const Scalar phi{"phi", units::none, required, positive, "mean volume fraction of the powder"},
    phiMax{"phiMax", units::none, required, positiveUpTo(1).saying("{:.6g} is no volume fraction"),
           "volume fraction at which powder is packed"},
    exponent{"exponent", units::none, required, positive, "exponent c of Krieger's law"},
    ratio{"ratio", units::none, required,
          positiveBelow(1).saying("D_c/D_eta must be above 0 and less than 1: from there on there is no steady state"),
          "D_c/D_eta of Phillips' fluxes"},
    pressureGradient{"pressureGradient", units::forcePerVolume, 0, "fall of the pressure along the flow; for U"},
    mu{"mu", units::viscosity, 1, positive, "viscosity of the binder; for U"};
const Choice section{"section",
                     {{"plane", "between plates, origin on one of them"},
                      {"circular", "a pipe: width is its diameter, origin on its axis"}},
                     "plane",
                     "of the channel"};
}

namespace
{
constexpr int intervals = 4000; // of the tables: the sums by parts below are then good to 1e-7

/// Argument at which `f`, which falls from `low` to `high`, passes `value`, by bisection.
double bisect(double low, double high, double value, const auto& f)
{
    for (int k = 0; k < 60; ++k)
    {
        const double middle = 0.5 * (low + high);
        (f(middle) > value ? low : high) = middle;
    }
    return 0.5 * (low + high);
}
}

EntryList SuspensionChannel::entries()
{
    return {entry::width,     entry::phi,    entry::phiMax, entry::exponent, entry::ratio,           entry::section,
            entry::direction, entry::normal, entry::origin, entry::mu,       entry::pressureGradient};
}

SuspensionChannel::SuspensionChannel(const Dictionary& d)
    : width_(entry::width(d)),
      phiMax_(entry::phiMax(d)),
      exponent_(entry::exponent(d)),
      speedScale_(0.25 * sqr(width_) * entry::pressureGradient(d) / entry::mu(d)),
      direction_(entry::direction(d)),
      normal_(entry::normal(d)),
      origin_(entry::origin(d)),
      pipe_(entry::section(d) == "circular")
{
    if (pipe_) speedScale_ *= 0.5;
    const double mean = entry::phi(d), ratio = entry::ratio(d);
    if (!pipe_ && std::abs(dot(direction_, normal_)) > 1e-6)
        entry::normal.error(d, "normal must be at right angles to direction, along which the flow goes");
    if (mean >= phiMax_) entry::phi.error(d, "must be less than phiMax");
    n_ = exponent_ * (1 / std::min(ratio, 0.999) - 1);
    // The mean grows with the value at the walls.
    const auto lessMean = [&](double phi)
    {
        wall_ = phi;
        return -meanPhi();
    };
    wall_ = bisect(0, std::min(mean, phiMax_), -mean, lessMean);
    integral_.assign(intervals + 1, 0);
    const auto slope = [&](int k) { return double(k) / intervals * std::pow(1 - phi(double(k) / intervals) / phiMax_, exponent_); };
    for (int k = intervals - 1; k >= 0; --k)
        integral_[std::size_t(k)] = integral_[std::size_t(k) + 1] + 0.5 * (slope(k) + slope(k + 1)) / intervals;
}

/// s of a phi between that of the walls and phi_m.
double SuspensionChannel::place(double phi) const { return wall_ / phi * std::pow((phiMax_ - phi) / (phiMax_ - wall_), n_); }

double SuspensionChannel::fromMiddle(const Vector<3>& x) const
{
    const auto d = x - origin_;
    return pipe_ ? mag(d - dot(d, direction_) * direction_) / (0.5 * width_) : std::abs(dot(d, normal_) / (0.5 * width_) - 1);
}

/// phi_0 + int_phi_0^phi_m s dphi (s^2 in a pipe), by the mid-point rule in a variable in which s is smooth at both ends.
double SuspensionChannel::meanPhi() const
{
    double sum = 0;
    for (int k = 0; k < intervals; ++k)
    {
        const double q = (k + 0.5) / intervals; // phi_m - phi = (phi_m - phi_0) q^p, p = max(1, 2/n)
        const double p = std::max(1.0, 2 / n_);
        const double s = place(phiMax_ - (phiMax_ - wall_) * std::pow(q, p));
        sum += (pipe_ ? s * s : s) * p * std::pow(q, p - 1);
    }
    return wall_ + (phiMax_ - wall_) * sum / intervals;
}

double SuspensionChannel::phi(double s) const
{
    return bisect(wall_, phiMax_, std::min(s, 1.0), [&](double phi) { return place(phi); });
}

double SuspensionChannel::speed(double s) const
{
    const double at = std::clamp(s, 0.0, 1.0) * intervals;
    const auto k = std::min(std::size_t(at), std::size_t(intervals - 1));
    return speedScale_ * (integral_[k] + (at - double(k)) * (integral_[k + 1] - integral_[k]));
}

}
