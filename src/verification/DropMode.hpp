/// Exact solution: the rate of the linear modes of a drop, in two and in three dimensions.
#pragma once
#include "verification/NormalMode.hpp"

namespace sph
{

/// Rate s [1/s] of mode n of a two-dimensional drop of radius R [m] in an unbounded second fluid, r = R + eta cos(n theta) exp(s t): period
/// 2 pi/Im s, decay rate -Re s. Exact in the linear limit, to which an oscillation from any start tends as its boundary layers form (Prosperetti
/// 1980); stream functions r^n, I_n(r sqrt(s rho_1/mu_1)) inside, r^-n, K_n(r sqrt(s rho_2/mu_2)) outside, and K = gamma (n^2 - 1)/R^2.
///
/// Without viscosity s^2 = -n (n^2 - 1) gamma/((rho_1 + rho_2) R^3) (Lamb 1932, art. 273); in a thin gas and with little viscosity
/// Re s = -2 n (n - 1) mu_1/(rho_1 R^2).
Complex dropMode(int n, double R, double gamma, const ModeFluid& drop, const ModeFluid& around);

/// The same of a ball, r = R + eta P_n(cos theta) exp(s t), n >= 2 (Miller & Scriven 1968; Prosperetti 1980): velocities curl curl (f(r) P_n r)
/// with f = r^n, i_n(r sqrt(s rho_1/mu_1)) inside, r^-(n+1), k_n(r sqrt(s rho_2/mu_2)) outside, i_n and k_n the modified spherical Bessel
/// functions, and K = gamma (n - 1)(n + 2)/R^2.
///
/// Without viscosity s^2 = -n (n + 1)(n - 1)(n + 2) gamma/(((n + 1) rho_1 + n rho_2) R^3), 8 gamma/(rho_1 R^3) of mode 2 in a vacuum (Rayleigh
/// 1879; Lamb 1932, art. 275); in a thin gas and with little viscosity Re s = -(n - 1)(2n + 1) mu_1/(rho_1 R^2) (Lamb 1932, art. 355).
Complex ballMode(int n, double R, double gamma, const ModeFluid& ball, const ModeFluid& around);

}
