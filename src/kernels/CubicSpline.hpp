/// Cubic spline, Monaghan & Lattanzio (1985):
///
///   W = k ((2 - q)^3 - 4 (1 - q)^3)/4,    q = 2 r/H,    k = 10/(7 pi h^2) in 2-D, 1/(pi h^3) in 3-D
///
/// Each bracket where positive; h = H/2. Erratum of Peng et al. (2014), eq. (2): the second piece is printed with (1 - q)^3 and is (2 - q)^3/4, as the
/// function must be continuous at q = 1.
#pragma once
#include "base/Vector.hpp"
#include <numbers>

namespace sph
{

template<int dim> struct CubicSpline
{
    static constexpr auto name = "cubicSpline";
    double H;
    double h = 0.5 * H, inverseh = 1 / h, k = dim == 2 ? 10 / (7 * std::numbers::pi * h * h) : 1 / (std::numbers::pi * h * h * h);

    auto W(auto r) const
    {
        const auto q = r * inverseh, a = fmax(decltype(r){}, 2 - q), b = fmax(decltype(r){}, 1 - q);
        return k * (0.25 * a * a * a - b * b * b);
    }
    auto dWdrOverR(auto r) const
    {
        const auto q = r * inverseh, a = fmax(decltype(r){}, 2 - q);
        const auto outside = -0.75 * a * a / fmax(q, decltype(q){0.5}), inside = -3 + 2.25 * q;
        return k * inverseh * inverseh * (q < 1 ? inside : outside);
    }
};

}
