/// Exact solution: the rate of linear waves on a plane interface.
#pragma once
#include "verification/NormalMode.hpp"

namespace sph
{

/// Rate s [1/s] of waves of wave number k [1/m] on a plane interface between a lower fluid and an upper one, each of the given depth [m] up to
/// a wall that it slips along: growth where the upper one is heavier (Rayleigh-Taylor). Exact in the linear limit: w = sinh(k y) and
/// sinh(y sqrt(k^2 + s rho/mu)) from each wall, K = (rho_1 - rho_2) g + gamma k^2 (Chandrasekhar 1961, chapter X, for infinite depth).
///
/// Without viscosity s^2 = [(rho_2 - rho_1) g k - gamma k^3]/(rho_1 + rho_2) tanh(k depth).
Complex planeMode(double k, double depth, double g, double gamma, const ModeFluid& lower, const ModeFluid& upper);

}
