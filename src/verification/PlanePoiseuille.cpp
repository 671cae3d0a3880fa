#include "verification/PlanePoiseuille.hpp"
#include "verification/flowEntries.hpp"
#include <numbers>

namespace sph
{

namespace entry
{
const Scalar acceleration{"acceleration", units::mPerS2, required, "of the force that drives the flow"};
}

namespace
{
constexpr double imagesUntil = 0.05; // nu t/L^2; both sums agree to round-off there with 5 images and 10 terms

/// Second repeated integral of the complementary error function (Abramowitz & Stegun 7.2.5).
double i2erfc(double z) { return 0.25 * ((1 + 2 * z * z) * std::erfc(z) - 2 * z * std::exp(-z * z) * std::numbers::inv_sqrtpi); }
}

PlanePoiseuille::PlanePoiseuille(double nu, double acceleration, double width)
    : nu_(nu), F_(acceleration), L_(width), direction_{1, 0, 0}, normal_{0, 1, 0}, steady_(false)
{}

PlanePoiseuille::PlanePoiseuille(const Dictionary& d)
    : nu_(entry::nu(d)),
      F_(entry::acceleration(d)),
      L_(entry::width(d)),
      direction_(entry::direction(d)),
      normal_(entry::normal(d)),
      origin_(entry::origin(d)),
      steady_(entry::steady(d))
{}

EntryList PlanePoiseuille::entries()
{
    return {entry::nu, entry::acceleration, entry::width, entry::direction, entry::normal, entry::origin, entry::steady};
}

double PlanePoiseuille::speed(double y, double t) const
{
    constexpr double pi = std::numbers::pi;
    const double parabola = F_ / (2 * nu_) * y * (L_ - y);
    if (steady_) return parabola;
    if (t <= 0) return 0;

    const double tau = nu_ * t / (L_ * L_);
    if (tau < imagesUntil)
    {
        const double s = 2 * std::sqrt(nu_ * t);
        double sum = 0;
        for (int k = 0, sign = 1; k < 5; ++k, sign = -sign) sum += sign * (i2erfc((k * L_ + y) / s) + i2erfc((k * L_ + L_ - y) / s));
        return F_ * t * (1 - 4 * sum);
    }
    double sum = 0;
    for (int n = 1; n < 20; n += 2) sum += std::sin(n * pi * y / L_) * std::exp(-n * n * pi * pi * tau) / (double(n) * n * n);
    return parabola - 4 * F_ * L_ * L_ / (nu_ * pi * pi * pi) * sum;
}

}
