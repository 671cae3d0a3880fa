/// The shear rate that powder migrates by:
///
///   gammaDot = sqrt(2 D:D),    D = (grad v + (grad v)^T)/2
///
/// [1/s]; |dv/dy| in simple shear. Erratum of Kauzlaric et al. (2011), definition of the shear rate: the whole quotient of gammaDot:gammaDot/2 is under the root, so
/// that mu gammaDot is the shear stress.
#pragma once
#include "fields/fieldTags.hpp"
#include "models/suspension/SuspensionConstants.hpp"
#include "plan/Coefficients.hpp"
#include <cmath>

namespace sph
{

/// sqrt(S:S/2) of a sum S = grad v + (grad v)^T, or of that times mu.
struct OfTensor
{
    static double finish(const auto&, const auto& S) { return std::sqrt(0.5 * doubleDot(S, S)); }
};

/// Shear rate from the viscous stress, with the pair viscosity and the corrected gradient:
///
///   S_i = sum_j V_j 2 mu_i mu_j/(mu_i + mu_j) ((v_j - v_i) L_i gradW_ij + transposed),    tau_i = sqrt(S_i:S_i/2),    gammaDot_i = tau_i/mu_i
///
/// The stress is smooth where the shear rate is not: in the middle of a channel gammaDot goes as the third power of the distance, and a
/// gradient of velocities smears it. With the stress four fifths of the error of phi in steady plane channel flow go
/// (tutorials/powderMoulding/channel9). mu [Pa s], V [m^3], v [m/s], L [1] the gradient's correction (operators/GradientCorrection.hpp),
/// tau [Pa]. Exact for linear velocities and one viscosity on disordered particles. Verified by test/unit/suspension.
struct ViscousShearStress : OfTensor
{
    static constexpr auto name = "viscousShearStress";
    using Provides = ShearStress;
    using Reads = Fields<Volume, Velocity, DynamicViscosity>;
    using ReadsOwn = Fields<CorrectionTensor>;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return j.V * 2 * i.mu * j.mu / (i.mu + j.mu) * twiceSymm(j.v - i.v, i.L * ij.gradW);
    }
};

struct ResolvedShear
{
    static constexpr auto name = "resolvedShear";
    using Provides = ShearRate;
    using ReadsOwn = Fields<ShearStress, DynamicViscosity>;
    auto operator()(const auto& i) const { return i.tau / i.mu; }
};

/// Contribution of the particle's own extent to the shear rate:
///
///   gammaDot_i = 1/mu_i sqrt(tau_i^2 + max(0, alpha Delta_x^2/2 laplacian(tau^2)_i)),    laplacian(f)_i = 2 sum_j V_j w_ij (f_j - f_i)
///
/// w = -(dW/dr)/r, over the fluid alone. Where a particle sits in the middle of a channel its gammaDot would be 0 but no flow through its
/// cell is without shear: alpha = 1/16 and 1/12 are the mean and the root mean square of |tau| over a cell where tau is linear, 0.025 was
/// best on four sets of parameters. Without it phi passes phi_m where D_eta/D_c c < 2.
struct SubParticleShear
{
    static constexpr auto name = "subParticleShear";
    using Provides = ShearRate;
    using Reads = Fields<Volume, ShearStress, GhostWall>;
    using ReadsOwn = Fields<DynamicViscosity>;
    double share;

    explicit SubParticleShear(const Coefficients& c) : share(c.of<Suspension>().shearShare) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const double V = j.wall > 0 ? 0.0 : j.V;
        return -2 * V * ij.dWdrOverR * (sqr(j.tau) - sqr(i.tau));
    }
    double finish(const auto& i, double laplacian) const { return std::sqrt(sqr(i.tau) + std::fmax(0.0, share * laplacian)) / i.mu; }
};

/// Shear rate from the velocity gradient, Kauzlaric et al. (2011), eq. (3.5):
///
///   gammaDot_i = sqrt(2 D_i:D_i) of grad v_i = sum_j V_j (v_j - v_i) gradW_ij
///
/// Erratum of Kauzlaric et al. (2011), eq. (3.5): the sum has the other sign, against eq. (3.1); the shear rate does not feel it.
struct VelocityGradientShear : OfTensor
{
    static constexpr auto name = "velocityGradientShear";
    using Provides = ShearRate;
    using Reads = Fields<Volume, Velocity>;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return j.V * twiceSymm(j.v - i.v, ij.gradW); }
};

/// Shear rate from the velocity gradient with the gradient corrected.
struct CorrectedGradientShear : OfTensor
{
    static constexpr auto name = "correctedGradientShear";
    using Provides = ShearRate;
    using Reads = Fields<Volume, Velocity>;
    using ReadsOwn = Fields<CorrectionTensor>;
    static constexpr bool ofRawGradient = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return j.V * twiceSymm(j.v - i.v, i.L * ij.gradW); }
};

}
