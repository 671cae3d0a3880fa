#include "BosanquetRise.hpp"
#include <algorithm>
#include <array>
#include <cmath>

namespace sph
{

double BosanquetRise::height(double t) const
{
    // In l^2 and the momentum P = rho l v nothing is singular at l = 0.
    using State = std::array<double, 2>;
    const double sinks = reservoirWidth > 0 ? 1 + width / reservoirWidth : 1;
    const auto column = [](const State& q) { return std::sqrt(std::max(0.0, q[0])); };
    const auto rate = [&](const State& q)
    {
        const double h = (column(q) - immersion) * sinks;
        return State{2 * q[1] / rho,
                     2 * gamma * cosTheta / width - pull - deltaRho * g * h - 12 * mu * q[1] / (rho * width * width)};
    };
    const auto sum = [](const State& a, double s, const State& b) { return State{a[0] + s * b[0], a[1] + s * b[1]}; };

    // Fourth order of Runge and Kutta; the steps resolve the viscous time rho w^2/(12 mu) and the swinging of the column.
    const int steps = 2000 + int(20 * t * (12 * mu / (rho * width * width) + std::sqrt(g / heightAtRest())));
    const double dt = t / steps;
    State q{immersion * immersion, 0};
    for (int k = 0; k < steps; ++k)
    {
        const auto a = rate(q), b = rate(sum(q, dt / 2, a)), c = rate(sum(q, dt / 2, b)), d = rate(sum(q, dt, c));
        for (std::size_t i = 0; i < 2; ++i) q[i] += dt / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    }
    return (column(q) - immersion) * sinks;
}

}
