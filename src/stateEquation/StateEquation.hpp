/// The equation of state of a phase, Tait's, the same for liquids and gases: eq. (7) ff. of Barker et al. (2012) after Becker & Teschner (2007).
///
///   p(rho) = B ((rho/rho_0)^n - 1),    B = rho_0 c^2/n
///
/// p [Pa] above the background pressure, rho [kg/m^3], rho_0 the density at rest, c [m/s] the sound speed there. n = 7 for liquids, 1.4 for gases;
/// 1 is the linear equation p = c^2 (rho - rho_0). A phase whose stress a law of its own gives has B = 0 and no pressure.
///
///     const auto water = StateEquation::tait(1000, 20, 7);
///     water.pressure(1001);        // 401.2 Pa
///     water.compression(401.2);    // 1.001
///
/// Verified by test/unit/stateEquation.
#pragma once
#include "base/Vector.hpp"
#include <cmath>

namespace sph
{

struct StateEquation
{
    double restDensity = 1; ///< rho_0 [kg/m^3]
    double B = 0;           ///< [Pa]
    double n = 1;

    static StateEquation tait(double restDensity, double soundSpeed, double n)
    {
        return {restDensity, restDensity * sqr(soundSpeed) / n, n};
    }

    double pressure(double rho) const { return B * (std::pow(rho / restDensity, n) - 1); }
    /// dp/drho = c^2 (rho/rho_0)^(n - 1) [m^2/s^2], the square of the sound speed at rho.
    double slope(double rho) const { return B * n / restDensity * std::pow(rho / restDensity, n - 1); }
    /// rho/rho_0 of a pressure above leastPressure().
    double compression(double p) const { return std::pow(1 + p / B, 1 / n); }
    /// No density has this pressure [Pa] or a lower one.
    double leastPressure() const { return -B; }
    /// int_(rho_0)^rho p/rho^2 drho [J/kg]
    double energy(double rho) const
    {
        const double q = rho / restDensity;
        const double power = std::fabs(n - 1) < 1e-9 ? std::log(q) : (std::pow(q, n - 1) - 1) / (n - 1);
        return B / restDensity * (power + 1 / q - 1);
    }
};

}
