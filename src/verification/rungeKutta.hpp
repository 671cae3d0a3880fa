/// One step of Runge and Kutta, fourth order: dq/dt = rate(q), for a rate that does not depend on t.
#pragma once
#include <array>

namespace sph
{

template<std::size_t n> std::array<double, n> rungeKuttaStep(const std::array<double, n>& q, double dt, const auto& rate)
{
    const auto moved = [&](double s, const std::array<double, n>& by)
    {
        auto to = q;
        for (std::size_t i = 0; i < n; ++i) to[i] += s * by[i];
        return to;
    };
    const auto a = rate(q), b = rate(moved(dt / 2, a)), c = rate(moved(dt / 2, b)), d = rate(moved(dt, c));
    auto next = q;
    for (std::size_t i = 0; i < n; ++i) next[i] += dt / 6 * (a[i] + 2 * b[i] + 2 * c[i] + d[i]);
    return next;
}

}
