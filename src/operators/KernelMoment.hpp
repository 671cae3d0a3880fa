/// Second moment of the kernel's slope, by which Laplacians are normalised (NUMERICS: the raw one is 4 % low however fine the
/// resolution):
///
///   M_i = -1/d sum_j W'_ij r_ij          -> sigma in the continuum
///
/// M [1/m^d], d dimensions, W' = dW/dr. Verified by test/unit/passes (continuum value) and tutorials/verification/planePoiseuille.
#pragma once
#include "fieldTags.hpp"

namespace sph
{

struct SecondMoment
{
    static constexpr auto name = "secondMoment";
    using Provides = KernelMoment;

    auto operator()(const auto& ij, const auto&, const auto&) const { return -1.0/dimensions(ij.x)*ij.dWdrOverR*sqr(ij.r); }
};

}
