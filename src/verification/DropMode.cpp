#include "verification/DropMode.hpp"
#include "verification/Bessel.hpp"
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

namespace
{

/// Values at the interface of curl curl (f(r) Y_n r), f(R) = 1, with slope f'(R) = `slope`: u_r = n (n + 1) f/r Y_n and u_t = (r f)'/r along the
/// surface gradient of Y_n.
/// `curl` [1/m^2] is kappa^2 of a vortical solution, 0 of a potential one, whose pressure is `p`.
AtInterface poloidal(int n, double R, double mu, Complex slope, Complex curl, Complex p)
{
    const double nn = n * (n + 1);
    const Complex f2 = curl + nn / (R * R) - 2.0 * slope / R; // from f'' + 2 f'/r - n (n + 1) f/r^2 = kappa^2 f
    return {nn / R, slope + 1 / R, mu * (f2 + (nn - 2) / (R * R)), -p + 2 * mu * nn * (slope / R - 1 / (R * R))};
}

/// i_(n-1)(z)/i_n(z), from i_(m-1) - i_(m+1) = (2m + 1)/z i_m downwards (Abramowitz & Stegun 10.2.18), from an order far above |z| on.
Complex ratioOfI(int n, Complex z)
{
    const int from = n + 40 + int(2 * std::abs(z));
    Complex ratio = (2.0 * from + 1) / z;
    for (int m = from - 1; m >= n; --m) ratio = (2.0 * m + 1) / z + 1.0 / ratio;
    return ratio;
}

/// k_(n-1)(z)/k_n(z), from k_(m+1) - k_(m-1) = (2m + 1)/z k_m upwards; k_-1 = k_0.
Complex ratioOfK(int n, Complex z)
{
    Complex ratio = 1;
    for (int m = 0; m < n; ++m) ratio = 1.0 / (ratio + (2.0 * m + 1) / z);
    return ratio;
}

}

Complex ballMode(int n, double R, double gamma, const ModeFluid& ball, const ModeFluid& around)
{
    const double K = gamma * (n - 1) * (n + 2) / (R * R);
    const double omega = std::sqrt(n * (n + 1) * K / (((n + 1) * ball.rho + n * around.rho) * R));
    const double decay = (n - 1) * (2 * n + 1) * ball.mu / (ball.rho * R * R);
    const auto determinant = [&](Complex s)
    {
        const Complex in = std::sqrt(s * ball.rho / ball.mu), out = std::sqrt(s * around.rho / around.mu);
        const Complex slopeIn = in * ratioOfI(n, in * R) - (n + 1) / R;     // i_n' = i_(n-1) - (n + 1)/z i_n
        const Complex slopeOut = -out * ratioOfK(n, out * R) - (n + 1) / R; // k_n' = -k_(n-1) - (n + 1)/z k_n
        // f = r^n is the gradient of (n + 1) r^n, r^-(n+1) that of -n r^-(n+1); p = -rho s of it.
        return mismatch({poloidal(n, R, ball.mu, n / R, 0, -(n + 1) * ball.rho * s), poloidal(n, R, ball.mu, slopeIn, in * in, 0)},
                        {poloidal(n, R, around.mu, -(n + 1) / R, 0, n * around.rho * s), poloidal(n, R, around.mu, slopeOut, out * out, 0)},
                        K, s);
    };
    return rateNear({-decay, omega}, determinant);
}

}
