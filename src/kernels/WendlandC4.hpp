/// Kernel Wendland C4, Wendland (1995), Dehnen & Aly (2012):
///
///   W = k (1 - s)^6 (1 + 6 s + 35/3 s^2),    s = r/H,    k = 9/(pi H^2) in 2-D, 495/(32 pi H^3) in 3-D
#pragma once
#include "base/Vector.hpp"
#include <numbers>

namespace sph
{

template<int dim> struct WendlandC4
{
    static constexpr auto name = "wendlandC4";
    double H;
    double k = dim == 2 ? 9 / (std::numbers::pi * H * H) : 495 / (32 * std::numbers::pi * H * H * H);
    double inverseH = 1 / H, kPrime = -56.0 / 3 * k / (H * H);

    auto W(auto r) const
    {
        const auto s = r * inverseH, a = fmax(decltype(r){}, 1 - s);
        return k * sqr(a * a * a) * (1 + 6 * s + 35.0 / 3 * s * s);
    }
    auto dWdrOverR(auto r) const
    {
        const auto s = r * inverseH, a = fmax(decltype(r){}, 1 - s);
        return kPrime * sqr(sqr(a)) * a * (1 + 5 * s);
    }
};

}
