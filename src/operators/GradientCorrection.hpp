/// Kernel-gradient correction, Bonet & Lok (1999): with it a sum of differences is exact for a linear field, however the particles lie.
///
///   L_i = B_i^-1,    B_i = -sum_j V_j x_ij gradW_ij,    grad f_i = L_i sum_j V_j (f_j - f_i) gradW_ij
///
/// L is the unit tensor where B has an eigenvalue below 0.1 (0.25 in a corner): lone particles and the tips of films, whose inverse would be noise.
/// V [m^3], L [1]. It acts on the raw gradient: the correction is its normalisation. Verified by test/unit/operators (plain loop; a linear pressure).
#pragma once
#include "fields/fieldTags.hpp"

namespace sph
{

/// B_i
struct MomentTensor
{
    using Reads = Fields<Volume>;
    static constexpr bool ofRawGradient = true;
    auto operator()(const auto& ij, const auto&, const auto& j) const { return -j.V * ij.dWdrOverR * outer(ij.x); }
};

struct GradientCorrection : MomentTensor
{
    static constexpr auto name = "gradientCorrection";
    using Provides = CorrectionTensor;
    static constexpr double least = 0.1;

    auto finish(const auto&, const auto& B) const { return leastEigenvalue(B) > least ? 1 / determinant(B) * adjugate(B) : identity(B); }
};

}
