/// Low pass of the pressure acceleration that the second-order ghost velocity reads: each evaluation moves it by a tenth of the way
/// (NUMERICS: 0.1, 0.3 and 1 were stable; 0.1 keeps sound waves out of the wall).
///
///   a_w += s (a_p - a_w)
#pragma once
#include "Coefficients.hpp"
#include "fieldTags.hpp"

namespace sph
{

struct WallFilter
{
    static constexpr auto name = "wallFilter";
    using Adds = WallAcceleration; // a state: it keeps its value between evaluations
    using ReadsOwn = Fields<WallAcceleration, PressureAcceleration>;
    double s;

    explicit WallFilter(const Coefficients& c) : s(c.wallFilter) {}
    auto operator()(const auto& i) const { return s*(i.a_p - i.a_w); }
};

}
