/// Exact solution: the rate of linear waves on a liquid column.
#pragma once
#include "verification/NormalMode.hpp"

namespace sph
{

/// Rate s [1/s] of axisymmetric waves of wave number k [1/m] on a liquid column of radius R [m] in an unbounded second fluid: growth for k R < 1
/// (Plateau-Rayleigh). Exact in the linear limit (Tomotika 1935, with inertia): potentials I_0(k r) inside and K_0(k r) outside, radial velocities
/// I_1(q r) and K_1(q r), q^2 = k^2 + s rho/mu, and K = gamma (k^2 - 1/R^2).
///
/// Without viscosity and outer fluid s^2 = gamma/(rho R^3) x (1 - x^2) I_1(x)/I_0(x), x = k R (Rayleigh 1878).
Complex columnMode(double k, double R, double gamma, const ModeFluid& column, const ModeFluid& around);

}
