#include "verification/ColumnMode.hpp"
#include "verification/Bessel.hpp"
#include <cmath>

namespace sph
{

namespace
{

/// Values at the interface of the solution with radial velocity u(r), u(R) = 1, and q u_0 = (r u)'/r at R; axial velocity and shear stress over i.
AtInterface solution(double k, double R, double mu, Complex qu_0, Complex q, Complex p)
{
    return {1, qu_0 / k, mu * (k + q * q / k), -p + 2 * mu * (qu_0 - 1 / R)};
}

}

Complex columnMode(double k, double R, double gamma, const ModeFluid& column, const ModeFluid& around)
{
    const double K = gamma * (k * k - 1 / (R * R));
    const auto inside = [R](Complex q) { return q * scaledBesselI(0, q * R) / scaledBesselI(1, q * R); };
    const auto outside = [R](Complex q) { return -q * scaledBesselK(0, q * R) / scaledBesselK(1, q * R); };
    const auto determinant = [&](Complex s)
    {
        const auto vortical = [&](const ModeFluid& f) { return std::sqrt(k * k + s * f.rho / f.mu); };
        const auto waves = [&](const ModeFluid& f, const auto& ratio)
        {
            const Complex q = vortical(f), p = -f.rho * s * ratio(k) / (k * k); // -rho s phi, phi'(R) = 1
            return std::array{solution(k, R, f.mu, ratio(k), k, p), solution(k, R, f.mu, ratio(q), q, 0)};
        };
        return mismatch(waves(column, inside), waves(around, outside), K, s);
    };
    // Rayleigh's rate with the damping of a slender thread, 3 mu k^2/rho (Eggers & Villermaux 2008).
    const Complex inviscid = -K * k * k / (column.rho * inside(k));
    const double damping = 1.5 * column.mu / column.rho * k * k;
    return rateNear(-damping + std::sqrt(damping * damping + inviscid), determinant);
}

}
