/// Quintic spline, Morris (1996):
///
///   W = k ((3 - q)^5 - 6 (2 - q)^5 + 15 (1 - q)^5),    q = 3 r/H,    k = 7/(478 pi h^2) in 2-D, 1/(120 pi h^3) in 3-D
///
/// Each bracket where positive; h = H/3.
#pragma once
#include "base/Vector.hpp"
#include <numbers>

namespace sph
{

template<int dim> struct QuinticSpline
{
    static constexpr auto name = "quinticSpline";
    double H;
    double h = H / 3, inverseh = 1 / h, k = dim == 2 ? 7 / (478 * std::numbers::pi * h * h) : 1 / (120 * std::numbers::pi * h * h * h);

    auto W(auto r) const
    {
        const auto q = r * inverseh, a = fmax(decltype(r){}, 3 - q), b = fmax(decltype(r){}, 2 - q), c = fmax(decltype(r){}, 1 - q);
        return k * (sqr(sqr(a)) * a - 6 * sqr(sqr(b)) * b + 15 * sqr(sqr(c)) * c);
    }
    auto dWdrOverR(auto r) const
    {
        const auto q = r * inverseh, a = fmax(decltype(r){}, 3 - q), b = fmax(decltype(r){}, 2 - q), c = fmax(decltype(r){}, 1 - q);
        const auto slope = -5 * (sqr(sqr(a)) - 6 * sqr(sqr(b)) + 15 * sqr(sqr(c)));
        return k * inverseh * inverseh * (q < 1e-4 ? -120.0 : slope / fmax(q, 1e-4));
    }
};

}
