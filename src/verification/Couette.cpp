#include "verification/Couette.hpp"
#include "verification/flowEntries.hpp"
#include <numbers>

namespace sph
{

namespace entry
{
const VectorParameter velocity{"velocity", units::mPerS, required, "of the plate that moves"};
}

namespace
{
constexpr double imagesBelow = 0.05; // nu t/L^2
}

Couette::Couette(double nu, double speed, double width) : nu_(nu), L_(width), V_{speed, 0, 0}, normal_{0, 1, 0}, steady_(false) {}

Couette::Couette(const Dictionary& d)
    : nu_(entry::nu(d)),
      L_(entry::width(d)),
      V_(entry::velocity(d)),
      normal_(entry::normal(d)),
      origin_(entry::origin(d)),
      steady_(entry::steady(d))
{}

EntryList Couette::entries() { return {entry::nu, entry::width, entry::velocity, entry::normal, entry::origin, entry::steady}; }

double Couette::relativeSpeed(double y, double t) const
{
    constexpr double pi = std::numbers::pi;
    if (steady_) return y / L_;
    if (t <= 0) return 0;

    const double tau = nu_ * t / (L_ * L_);
    double sum = 0;
    if (tau < imagesBelow)
    {
        const double s = 2 * std::sqrt(nu_ * t);
        for (int k = 0; k < 4; ++k) sum += std::erfc((2 * k * L_ + L_ - y) / s) - std::erfc((2 * k * L_ + L_ + y) / s);
        return sum;
    }
    for (int n = 1; n < 15; ++n) sum += (n % 2 ? -1 : 1) * 2 / (n * pi) * std::sin(n * pi * y / L_) * std::exp(-n * n * pi * pi * tau);
    return y / L_ + sum;
}

}
