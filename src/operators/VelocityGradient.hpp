/// Velocity gradient with the kernel-gradient correction of Bonet & Lok (1999), blended out where the fluid ends:
///
///   L_i = G_i C_i,    G_i = sum_j V_j (v_j - v_i) (x) gradW_ij,    B_i = -sum_j V_j x_ij (x) gradW_ij
///   C_i = w B_i^-1 + (1 - w) I,    w = min(1, max(0, 1 + (lambda_i - lambda_c)/0.1)),    lambda_i = least eigenvalue of B_i
///
/// L_ab = dv_a/dx_b [1/s], V [m^3], v [m/s]; lambda_c [1] is `CorrectedFrom`. Since B is symmetric, G C is the sum with the corrected gradient C gradW, and both
/// sums take one pass. Exact for linear velocities, however the particles lie, where lambda >= lambda_c. Inside a block of particles 0.2 spacings off their lattice lambda is 0.8 and more, but not 0.9
/// (test SoilBlock); below a free surface 0.5 (FreeSurface.hpp). A collapse of soil with the full correction up to its surface blew up in every variant of a prototype; from 0.8 on it did not.
/// Of the raw gradient: the correction is its normalisation. Verified by test/unit/soil.
#pragma once
#include "fields/fieldTags.hpp"
#include "plan/Coefficients.hpp"
#include <algorithm>

namespace sph
{

// clang-format off
struct VelocityGradient { static constexpr FieldInfo info{"velocityGradient", "1/s"}; template<int dim, class Real = double> struct At { Tensor<dim, Real> L; }; };
// clang-format on

/// lambda_c, and the blending w.
struct CorrectedFrom
{
    double lambda = 0.8;
    static constexpr double blending = 0.1;
    double share(double leastEigenvalue) const { return std::clamp(1 + (leastEigenvalue - lambda) / blending, 0.0, 1.0); }
};
/// The scene's lambda_c, or the default.
inline CorrectedFrom correctedFrom(const Coefficients& c) { return c.has<CorrectedFrom>() ? c.of<CorrectedFrom>() : CorrectedFrom{}; }

/// B and G of one pass.
template<int dim> struct GradientSums
{
    SymmTensor<dim> B;
    Tensor<dim> G;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.B, q.G); }
};

struct CorrectedVelocityGradient
{
    static constexpr auto name = "velocityGradient";
    using Provides = VelocityGradient;
    using Reads = Fields<Volume, Velocity>;
    static constexpr bool ofRawGradient = true;
    CorrectedFrom corrected;

    explicit CorrectedVelocityGradient(const Coefficients& c) : corrected(correctedFrom(c)) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return GradientSums<dimensions(decltype(ij.x){})>{-j.V * ij.dWdrOverR * outer(ij.x), outer(j.V * (j.v - i.v), ij.gradW)};
    }
    auto finish(const auto&, const auto& sum) const
    {
        const double w = corrected.share(leastEigenvalue(sum.B));
        if (!(w > 0)) return sum.G;
        return sum.G * full(w / determinant(sum.B) * adjugate(sum.B) + (1 - w) * identity(sum.B));
    }
};

}
