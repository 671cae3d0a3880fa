#include "verification/BosanquetRise.hpp"
#include "verification/rungeKutta.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace sph
{

double BosanquetRise::height(double t) const
{
    // Nothing is singular at l = 0 in l^2 and the momentum P = rho l v (of both columns with a slip length).
    using State = std::array<double, 2>;
    const double sinks = reservoirWidth > 0 ? 1 + width / reservoirWidth : 1;
    const auto column = [](const State& q) { return std::sqrt(std::max(0.0, q[0])); };
    const double ratio = reservoirWidth > 0 ? width / reservoirWidth : 0, ends = 4 * width / (3 * std::numbers::pi) * (1 + ratio * ratio);
    const auto rate = [&](const State& q)
    {
        const double l = column(q), h = (l - immersion) * sinks;
        double lv = q[1] / rho, longer = 1, cosine = cosTheta;
        if (slipLength > 0)
        {
            const double reservoir = immersion - (l - immersion) * ratio;
            lv *= l / (l + reservoir * ratio);
            longer = (l + reservoir * ratio * ratio * ratio + ends) / l;
            const double angle = std::acos(cosTheta),
                         bent = angle * angle * angle + 9 * mu / gamma * lv / l * std::log(width / (2 * slipLength));
            cosine = std::cos(std::cbrt(bent));
        }
        return State{2 * lv, 2 * gamma * cosine / width - pull - deltaRho * g * h - 12 * mu * lv * longer / (width * width)};
    };

    // The steps resolve the viscous time rho w^2/(12 mu) and the swinging of the column.
    const double wanted = 20 * t * (12 * mu / (rho * width * width) + std::sqrt(g / heightAtRest())), most = 1e7;
    if (!(wanted <= most)) return std::numeric_limits<double>::quiet_NaN();
    const int steps = 2000 + int(wanted);
    const double dt = t / steps;
    State q{immersion * immersion, 0};
    for (int k = 0; k < steps; ++k) q = rungeKuttaStep(q, dt, rate);
    return (column(q) - immersion) * sinks;
}

}
