/// The largest step at which sound does not grow where the density is integrated, from the kernel.
#pragma once
#include <string>

namespace sph
{

/// A wave e^(i k.x) of density and velocity on a lattice at rest:
///
///   dr/dt = -i w v - D r,   dv/dt = -i w r - A v,   r = c (rho - rho_0)/rho_0
///   w = c |sum_j V gradW sin k.x_j|,    D = delta h c sum_j F_j (1 - cos k.x_j - 1/2 g.x_j sin k.x_j),    A = alpha h c sum_j (F_j/2) (1 - cos k.x_j) (e.x_j)^2/r_j^2
///   F_j = -2 V x_j.gradW/(r_j^2 + 0.01 h^2),   g the renormalised gradient's k, 0 with the form of Molteni & Colagrossi
///
/// V [m^dim] volume, h = H/2 [m], c [m/s], e the wave's direction. Schemes of second order that take the rates of half a step on make undamped waves grow, by (w dt)^4/4 a
/// step where rates are extrapolated (leapfrog: Adams & Bashforth) and by (w dt)^4/8 where they are evaluated (predictorCorrector: the mid-point rule): a step is
/// stable as long as D and A take more. How long it may be hangs on the kernel's shape and hardly on its support. Verified by test/unit/pressure (StableSound).
struct DampedSound
{
    std::string kernel;
    double support = 0; ///< H in spacings
    int dimension = 2;
    double delta = 0, alpha = 0;
    bool renormalised = false; ///< the diffusion
    bool extrapolates = false; ///< rates

    bool operator==(const DampedSound&) const = default;
};

/// c dt/h at the most; infinite where it lies beyond all other limits, 2.
double stableSoundStep(const DampedSound&);

}
