#include "verification/Bessel.hpp"
#include <numbers>

namespace sph
{

// Trapezoidal rules: of a periodic analytic function and of one that falls off doubly exponentially they converge faster than any power of
// the step; the numbers of intervals leave round-off.

std::complex<double> scaledBesselI(int n, std::complex<double> z)
{
    constexpr double pi = std::numbers::pi;
    const int intervals = 64 + 2 * int(std::abs(z));
    std::complex<double> sum;
    for (int k = 0; k <= intervals; ++k)
    {
        const double a = pi * k / intervals, weight = k == 0 || k == intervals ? 0.5 : 1;
        sum += weight * std::exp(z * (std::cos(a) - 1)) * std::cos(n * a);
    }
    return sum / double(intervals);
}

std::complex<double> scaledBesselK(int n, std::complex<double> z)
{
    constexpr int intervals = 1000;
    constexpr double negligible = 50; // -ln of what is left out
    const double step = std::acosh(1 + negligible / z.real()) / intervals;
    std::complex<double> sum = 0.5;
    for (int k = 1; k <= intervals; ++k)
    {
        const double a = k * step;
        sum += std::exp(-z * (std::cosh(a) - 1)) * std::cosh(n * a);
    }
    return sum * step;
}

}
