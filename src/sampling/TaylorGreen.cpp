#include "TaylorGreen.hpp"
#include <numbers>

namespace sph
{

TaylorGreen::TaylorGreen(double speed, double period, double nu, double rho) : U_(speed), L_(period), nu_(nu), rho_(rho) {}

TaylorGreen::TaylorGreen(const Dictionary& d)
    : U_(d.getPositive("speed", units::mPerS)),
      L_(d.getPositive("period", units::m)),
      nu_(d.getNonNegative("nu", units::kinematicViscosity, 0)),
      rho_(d.getPositive("rho", units::density, 1)),
      origin_(d.get("origin", Vector<3>{}))
{
}

Vector<3> TaylorGreen::velocity(const Vector<3>& x, double t) const
{
    const double k = 2 * std::numbers::pi / L_;
    const auto r = x - origin_;
    const double U = U_ * std::exp(-2 * nu_ * k * k * t);
    return {-U * std::cos(k * r.x) * std::sin(k * r.y), U * std::sin(k * r.x) * std::cos(k * r.y), 0};
}

double TaylorGreen::pressure(const Vector<3>& x, double t) const
{
    const double k = 2 * std::numbers::pi / L_;
    const auto r = x - origin_;
    const double U = U_ * std::exp(-2 * nu_ * k * k * t);
    return -rho_ * U * U / 4 * (std::cos(2 * k * r.x) + std::cos(2 * k * r.y));
}

}
