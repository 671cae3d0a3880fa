#include "SuspensionChannel.hpp"
#include "readDirection.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{
constexpr int intervals = 4000; // of the tables: the sums by parts below are then good to 1e-7

/// Where `f`, which falls from `low` to `high`, passes `value`.
double bisect(double low, double high, double value, const auto& f)
{
    for (int k = 0; k < 60; ++k)
    {
        const double middle = 0.5*(low + high);
        (f(middle) > value ? low : high) = middle;
    }
    return 0.5*(low + high);
}
}

SuspensionChannel::SuspensionChannel(const Dictionary& d)
    : width_(d.getPositive("width", units::m)),
      phiMax_(d.getPositive("phiMax", units::none)),
      exponent_(d.getPositive("exponent", units::none)),
      speedScale_(0.25*sqr(width_)*d.get("pressureGradient", units::forcePerVolume, 0)/d.getPositive("mu", units::viscosity, 1)),
      direction_(readDirection(d, "direction", {1, 0, 0})),
      normal_(readDirection(d, "normal", {0, 1, 0})),
      origin_(d.get("origin", Vector<3>{})),
      pipe_(d.choose("section", std::vector<std::string>{"plane", "circular"}, "plane") == "circular")
{
    if (pipe_) speedScale_ *= 0.5;
    const double mean = d.getPositive("phi", units::none), ratio = d.getPositive("ratio", units::none);
    if (ratio >= 1) d.error("ratio", "D_c/D_eta must be less than 1: from there on there is no steady state");
    if (phiMax_ > 1) d.error("phiMax", fmt::format("{:.6g} is no volume fraction", phiMax_));
    if (!pipe_ && std::abs(dot(direction_, normal_)) > 1e-6) d.error("normal", "normal must be at right angles to direction, along which the flow goes");
    if (mean >= phiMax_) d.error("phi", "must be less than phiMax");
    n_ = exponent_*(1/std::min(ratio, 0.999) - 1);
    // The mean grows with the value at the walls.
    const auto lessMean = [&](double phi)
    {
        wall_ = phi;
        return -meanPhi();
    };
    wall_ = bisect(0, std::min(mean, phiMax_), -mean, lessMean);
    integral_.assign(intervals + 1, 0);
    const auto slope = [&](int k) { return double(k)/intervals*std::pow(1 - phi(double(k)/intervals)/phiMax_, exponent_); };
    for (int k = intervals - 1; k >= 0; --k) integral_[std::size_t(k)] = integral_[std::size_t(k) + 1] + 0.5*(slope(k) + slope(k + 1))/intervals;
}

/// s of a phi between that of the walls and phi_m.
double SuspensionChannel::place(double phi) const { return wall_/phi*std::pow((phiMax_ - phi)/(phiMax_ - wall_), n_); }

double SuspensionChannel::fromMiddle(const Vector<3>& x) const
{
    const auto d = x - origin_;
    return pipe_ ? mag(d - dot(d, direction_)*direction_)/(0.5*width_) : std::abs(dot(d, normal_)/(0.5*width_) - 1);
}

/// phi_0 + int_phi_0^phi_m s dphi (s^2 in a pipe), by the mid-point rule in a variable in which s is smooth at both ends.
double SuspensionChannel::meanPhi() const
{
    double sum = 0;
    for (int k = 0; k < intervals; ++k)
    {
        const double q = (k + 0.5)/intervals; // phi_m - phi = (phi_m - phi_0) q^p, p = max(1, 2/n)
        const double p = std::max(1.0, 2/n_);
        const double s = place(phiMax_ - (phiMax_ - wall_)*std::pow(q, p));
        sum += (pipe_ ? s*s : s)*p*std::pow(q, p - 1);
    }
    return wall_ + (phiMax_ - wall_)*sum/intervals;
}

double SuspensionChannel::phi(double s) const
{
    return bisect(wall_, phiMax_, std::min(s, 1.0), [&](double phi) { return place(phi); });
}

double SuspensionChannel::speed(double s) const
{
    const double at = std::clamp(s, 0.0, 1.0)*intervals;
    const auto k = std::min(std::size_t(at), std::size_t(intervals - 1));
    return speedScale_*(integral_[k] + (at - double(k))*(integral_[k + 1] - integral_[k]));
}

}
