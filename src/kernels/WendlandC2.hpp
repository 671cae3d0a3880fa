/// Kernel Wendland C2, Wendland (1995), Dehnen & Aly (2012):
///
///   W = k (1 - s)^4 (1 + 4 s),    s = r/H,    k = 7/(pi H^2) in 2-D, 21/(2 pi H^3) in 3-D
///
/// Positive Fourier transform: does not pair.
#pragma once
#include "base/Vector.hpp"
#include <numbers>

namespace sph
{

template<int dim> struct WendlandC2
{
    static constexpr auto name = "wendlandC2";
    double H;
    double k = dim == 2 ? 7 / (std::numbers::pi * H * H) : 21 / (2 * std::numbers::pi * H * H * H);
    double inverseH = 1 / H, kPrime = -20 * k / (H * H);

    auto W(auto r) const
    {
        const auto s = r * inverseH, a = fmax(decltype(r){}, 1 - s);
        return k * sqr(sqr(a)) * (1 + 4 * s);
    }
    auto dWdrOverR(auto r) const
    {
        const auto a = fmax(decltype(r){}, 1 - r * inverseH);
        return kPrime * a * a * a;
    }
};

}
