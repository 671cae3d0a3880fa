/// Linear modes exp(s t) of an interface between two viscous fluids, from the four solutions of the linearised Navier-Stokes equations that meet
/// there: in each fluid one that is a potential flow and one that carries the vorticity.
#pragma once
#include <array>
#include <complex>
#include <functional>

namespace sph
{

using Complex = std::complex<double>;

/// Values of a solution of one fluid at the interface, all in units of its own amplitude.
struct AtInterface
{
    Complex normalVelocity, tangentialVelocity; ///< [m/s]
    Complex shearStress, normalStress;          ///< [Pa]; normalStress = -p + 2 mu du_n/dn
};

/// One fluid's density [kg/m^3] and viscosity [Pa s].
struct ModeFluid
{
    double rho, mu;
};

/// Zero where s [1/s] is a rate of the interface: the determinant of
///
///   u_n, u_t and the shear stress continuous,   sigma_nn,1 - sigma_nn,2 + K eta = 0,   s eta = u_n
///
/// K [Pa/m] is what the interface answers to a displacement eta [m] towards the second fluid: capillarity and gravity.
Complex mismatch(const std::array<AtInterface, 2>& first, const std::array<AtInterface, 2>& second, double K, Complex s);

/// The rate s near `start` at which f vanishes, by the secant method.
Complex rateNear(Complex start, const std::function<Complex(Complex)>& f);

}
