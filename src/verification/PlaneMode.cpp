#include "verification/PlaneMode.hpp"
#include <cmath>

namespace sph
{

namespace
{

/// w = sinh(q y)/cosh(q depth) from the wall, `up` = 1 below the interface, -1 above; tangential velocity and shear stress over i.
AtInterface solution(double k, double depth, double mu, double up, Complex q, Complex p)
{
    const Complex w = std::tanh(q * depth), slope = up * q;
    return {w, slope / k, mu * (q * q / k + k) * w, -p + 2 * mu * slope};
}

}

Complex planeMode(double k, double depth, double g, double gamma, const ModeFluid& lower, const ModeFluid& upper)
{
    const double K = (lower.rho - upper.rho) * g + gamma * k * k, rho = lower.rho + upper.rho;
    const Complex inviscid = -K * k / rho * std::tanh(k * depth);
    const double damping = (lower.mu + upper.mu) / rho * k * k;
    const auto determinant = [&](Complex s)
    {
        const auto vortical = [&](const ModeFluid& f) { return std::sqrt(k * k + s * f.rho / f.mu); };
        return mismatch({solution(k, depth, lower.mu, 1, k, -lower.rho * s / k), solution(k, depth, lower.mu, 1, vortical(lower), 0)},
                        {solution(k, depth, upper.mu, -1, k, upper.rho * s / k), solution(k, depth, upper.mu, -1, vortical(upper), 0)}, K,
                        s);
    };
    return rateNear(-damping + std::sqrt(damping * damping + inviscid), determinant);
}

}
