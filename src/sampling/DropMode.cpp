#include "sampling/DropMode.hpp"
#include "sampling/Bessel.hpp"
#include <cmath>

namespace sph
{

namespace
{

/// Values at the interface of the stream function f(r) exp(i n theta), f(R) = 1, with slope f'(R) = `slope`; velocities and stresses over i where they need it.
/// `curl` [1/m^2] is kappa^2 of a vortical solution, 0 of a potential one, whose pressure over i is `p`.
AtInterface solution(int n, double R, double mu, Complex slope, Complex curl, Complex p)
{
    const Complex f2 = curl + double(n * n) / (R * R) - slope / R; // from f'' + f'/r - n^2 f/r^2 = kappa^2 f
    return {n / R, slope, mu * (f2 - slope / R + n * n / (R * R)), -p + 2 * mu * n * (slope / R - 1 / (R * R))};
}

}

Complex dropMode(int n, double R, double gamma, const ModeFluid& drop, const ModeFluid& around)
{
    const double K = gamma * (n * n - 1) / (R * R), rho = drop.rho + around.rho;
    const double omega = std::sqrt(n * K / (rho * R)), decay = 2 * n * (n - 1) * drop.mu / (rho * R * R);
    const auto determinant = [&](Complex s)
    {
        const Complex in = std::sqrt(s * drop.rho / drop.mu), out = std::sqrt(s * around.rho / around.mu);
        const Complex slopeIn = in * scaledBesselI(n - 1, in * R) / scaledBesselI(n, in * R) - n / R;
        const Complex slopeOut = -out * scaledBesselK(n - 1, out * R) / scaledBesselK(n, out * R) - n / R;
        return mismatch({solution(n, R, drop.mu, n / R, 0, -drop.rho * s), solution(n, R, drop.mu, slopeIn, in * in, 0)},
                        {solution(n, R, around.mu, -n / R, 0, around.rho * s), solution(n, R, around.mu, slopeOut, out * out, 0)}, K, s);
    };
    return rateNear({-decay, omega}, determinant);
}

}
