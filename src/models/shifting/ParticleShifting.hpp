/// Gradient of the particle concentration, down which particle shifting moves: Lind et al. (2012), with the factor 2 V_i.
///
///   shift_i = -2 V_i sum_j gradW_ij,      then  dx_i = C |v| dt Delta_x shift_i
///
/// V [m^3]; shift [1/m]; C 2 to 8; Delta_x the particle spacing; |v| the particle's own speed or, with `shiftingSpeed largest;`, that of the
/// fastest: lattices are torn where streamlines part, at points of no speed (tutorials/verification/taylorGreen: 2.8 to 3.8 % of error with
/// the own speed and C = 4, 1.2 to 2 % with the largest). Conserves nothing: it moves particles through the flow field.
#pragma once
#include "fieldTags.hpp"

namespace sph
{

struct ConcentrationSum
{
    using ReadsOwn = Fields<Volume>;
    auto operator()(const auto& ij, const auto& i, const auto&) const { return -2*i.V*ij.gradW; }
};
struct ConcentrationGradient : ConcentrationSum
{
    static constexpr auto name = "particleShifting";
    using Provides = ShiftDirection;
};

/// The same into a field of its own, for what a free surface leaves of it.
struct SeparateConcentrationGradient : ConcentrationSum
{
    static constexpr auto name = "concentrationGradient";
    using Provides = ConcentrationSlope;
};

/// Shifting where there is a free surface: along it and never across, Sun et al. (2017), eq. (22), after Lind et al. (2012).
///
///   shift_i = s_i                  lambda_i > 0.93       inside
///           = s_i - (s_i.n) n      0.4 < lambda_i        within two rows of the surface; only where s_i points outwards: s_i.n > 0
///           = 0                    lambda_i < 0.4        spray, and the tips of thin films
///
/// s_i as above, lambda and n of FreeSurface.hpp. The fluid ends at a surface, and what is missing there is not a low concentration:
/// shifted towards it, the first row evaporates.
struct SurfaceShifting
{
    static constexpr auto name = "surfaceShifting";
    using Provides = ShiftDirection;
    using ReadsOwn = Fields<ConcentrationSlope, LeastEigenvalue, SurfaceNormal>;
    static constexpr double inside = 0.93, isolated = 0.4;

    auto operator()(const auto& i) const
    {
        const double outwards = std::fmax(0.0, dot(i.gradN, i.n))/(dot(i.n, i.n) + 1e-300);
        const double across = i.lambda > inside ? 0.0 : outwards;
        const double moves = i.lambda > isolated ? 1.0 : 0.0;
        return moves*(i.gradN - across*i.n);
    }
};

}
