#include "verification/TaylorGreen.hpp"
#include "sampling/sharedEntries.hpp"
#include <numbers>

namespace sph
{

namespace entry
{
const Scalar speed{"speed", units::mPerS, required, positive, "largest speed at the start"},
    vortexPeriod{"period", units::m, required, positive, "of the vortices"},
    viscosity{"nu", units::kinematicViscosity, 0, nonNegative, "kinematic viscosity"},
    vortexRho{"rho", units::density, 1, positive, "density"};
}

TaylorGreen::TaylorGreen(double speed, double period, double nu, double rho) : U_(speed), L_(period), nu_(nu), rho_(rho) {}

TaylorGreen::TaylorGreen(const Dictionary& d)
    : U_(entry::speed(d)), L_(entry::vortexPeriod(d)), nu_(entry::viscosity(d)), rho_(entry::vortexRho(d)), origin_(entry::origin(d))
{}

EntryList TaylorGreen::entries() { return {entry::speed, entry::vortexPeriod, entry::viscosity, entry::vortexRho, entry::origin}; }

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
