/// Free surfaces, found by the moment tensor of the kernel's slope, Marrone et al. (2010).
///
///   B_i = -sum_j V_j x_ij gradW_ij,    lambda_i = least eigenvalue of B_i,    n_i = sum_j V_j (lambda_i - lambda_j) gradW_ij
///
/// B is the unit tensor inside the fluid (0.97 to 1 on a lattice), half of that on a plane surface and nothing at a lone particle. With a
/// support of 2.6 or 3 spacings lambda is 0.49 in the first row of particles, 0.84 to 0.9 in the second and that of the interior behind.
/// n points out of the fluid. Both are of the raw gradient: B is what a normalisation would be made of.
///
/// V [m^3], lambda [1], n [1/m]. Verified by test/unit/operators (plain loop; rows below a surface).
#pragma once
#include "operators/GradientCorrection.hpp"

namespace sph
{

struct SurfaceDetection : MomentTensor
{
    static constexpr auto name = "surfaceDetection";
    using Provides = LeastEigenvalue;

    auto finish(const auto&, const auto& B) const { return leastEigenvalue(B); }
};

struct OutwardNormal
{
    static constexpr auto name = "surfaceNormal";
    using Provides = SurfaceNormal;
    using Reads = Fields<Volume, LeastEigenvalue>;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return j.V * (i.lambda - j.lambda) * ij.gradW; }
};

}
