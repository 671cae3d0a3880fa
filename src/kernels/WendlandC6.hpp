/// Kernel Wendland C6, Wendland (1995), Dehnen & Aly (2012):
///
///   W = k (1 - s)^8 (1 + 8 s + 25 s^2 + 32 s^3),    s = r/H,    k = 78/(7 pi H^2) in 2-D, 1365/(64 pi H^3) in 3-D
#pragma once
#include "base/Vector.hpp"
#include <numbers>

namespace sph
{

template<int dim> struct WendlandC6
{
    static constexpr auto name = "wendlandC6";
    double H;
    double k = dim == 2 ? 78 / (7 * std::numbers::pi * H * H) : 1365 / (64 * std::numbers::pi * H * H * H);
    double inverseH = 1 / H, kPrime = -22 * k / (H * H);

    auto W(auto r) const
    {
        const auto s = r * inverseH, a = fmax(decltype(r){}, 1 - s);
        return k * sqr(sqr(sqr(a))) * (1 + s * (8 + s * (25 + s * 32)));
    }
    auto dWdrOverR(auto r) const
    {
        const auto s = r * inverseH, a = fmax(decltype(r){}, 1 - s);
        return kPrime * sqr(sqr(a)) * a * a * a * (1 + s * (7 + 16 * s));
    }
};

}
