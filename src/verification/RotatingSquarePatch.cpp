#include "verification/RotatingSquarePatch.hpp"
#include <cmath>
#include <numbers>

namespace sph
{

namespace entry
{
const Scalar side{"side", units::m, required, positive, "of the square"},
    omega{"omega", units::none / units::s, required, "rate of rotation"}, patchRho{"rho", units::density, 1000, positive, "density"};
const VectorParameter patchCentre{"centre", units::m, Vector<3>{}, "of the square"};
}

RotatingSquarePatch::RotatingSquarePatch(double side, double omega, double rho) : side_(side), omega_(omega), rho_(rho) {}

RotatingSquarePatch::RotatingSquarePatch(const Dictionary& d)
    : side_(entry::side(d)), omega_(entry::omega(d)), rho_(entry::patchRho(d)), centre_(entry::patchCentre(d))
{}

EntryList RotatingSquarePatch::entries() { return {entry::side, entry::omega, entry::patchRho, entry::patchCentre}; }

double RotatingSquarePatch::pressure(const Vector<3>& x, double) const
{
    const auto r = (x - centre_) / side_;
    const double X = std::abs(r.x), Y = std::abs(r.y);
    if (X >= 0.5 || Y >= 0.5) return 0;
    double sum = X * X - 0.25;
    // The ratio cosh/cosh is 1 on the sides and the terms fall as 1/n^3: to 1e-6 of the sum at n = 199.
    for (int n = 1; n < 200; n += 2)
    {
        const double k = n * std::numbers::pi;
        const double ratio = std::exp(k * (Y - 0.5)) * (1 + std::exp(-2 * k * Y)) / (1 + std::exp(-k));
        sum += (n % 4 == 1 ? 8 : -8) / (k * k * k) * std::cos(k * X) * ratio;
    }
    return rho_ * omega_ * omega_ * side_ * side_ * sum;
}

}
