/// Gradient of the particle concentration, down which particle shifting moves: Lind et al. (2012), with the factor 2 V_0 of NUMERICS.
///
///   shift_i = -2 V_i sum_j gradW_ij,      then  dx_i = C |v_i| dt Delta_x shift_i
///
/// V [m^3]; shift [1/m]; C about 2; Delta_x the particle spacing. Conserves nothing: it moves particles through the flow field.
#pragma once
#include "fieldTags.hpp"

namespace sph
{

struct ConcentrationGradient
{
    static constexpr auto name = "particleShifting";
    using Provides = ShiftDirection;
    using ReadsOwn = Fields<Volume>;

    auto operator()(const auto& ij, const auto& i, const auto&) const { return -2*i.V*ij.gradW; }
};

}
