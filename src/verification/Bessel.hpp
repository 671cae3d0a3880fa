/// Modified Bessel functions of whole order and complex argument with a positive real part, which the standard library does not have.
#pragma once
#include <complex>

namespace sph
{

/// exp(-z) I_n(z) = 1/pi int_0^pi exp(z (cos a - 1)) cos(n a) da     (Abramowitz & Stegun 9.6.19)
std::complex<double> scaledBesselI(int n, std::complex<double> z);

/// exp(z) K_n(z) = int_0^inf exp(-z (cosh a - 1)) cosh(n a) da       (Abramowitz & Stegun 9.6.24)
std::complex<double> scaledBesselK(int n, std::complex<double> z);

}
