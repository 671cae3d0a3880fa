/// J_eta of PhillipsFlux.hpp by itself, as a linear operator on a change q of phi, B held:
///
///   m_i/rho_0 (K q)_i = -sum_j V_i V_j w_ij (B_i + B_j) (q_i - q_j),    B = D_eta a^2 gammaDot phi^2 1/mu dmu/dphi
///
/// Symmetric and negative in the product sum_i m_i a_i b_i; sum_i m_i (K q)_i = 0 to round-off. Near phi_m B is hundreds of times D_c a^2 gammaDot phi, by
/// which J_c limits a step; a step that takes J_eta at its end is left with the latter (Migration.hpp). Verified by test/unit/suspension.
#pragma once
#include "fields/fieldTags.hpp"
#include "models/suspension/SuspensionConstants.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

// clang-format off
struct ViscosityDiffusivity { static constexpr FieldInfo info{"viscosityDiffusivity", "m^2/s"};  template<int dim, class Real = double> struct At { Real B; }; };
struct PowderChange         { static constexpr FieldInfo info{"dphi", "1"};                       template<int dim, class Real = double> struct At { Real q; }; };
struct PowderResponse       { static constexpr FieldInfo info{"dphidtOfChange", "1/s"};           template<int dim, class Real = double> struct At { Real response; }; };
struct PowderRelaxation     { static constexpr FieldInfo info{"powderRelaxation", "1/s"};         template<int dim, class Real = double> struct At { Real lambda; }; };
// clang-format on

struct DiffusivityOfViscosity
{
    static constexpr auto name = "diffusivityOfViscosity";
    using Provides = ViscosityDiffusivity;
    using ReadsOwn = Fields<PowderFraction, ShearRate, RelativeViscositySlope>;
    double Deta_a2;

    explicit DiffusivityOfViscosity(const Coefficients& c) : Deta_a2(c.of<Suspension>().Deta_a2) {}
    auto operator()(const auto& i) const { return Deta_a2 * i.gammaDot * sqr(i.phi) * i.slope; }
};

struct ViscosityFluxSum
{
    using ReadsOwn = Fields<Mass>;
    double rho_0;

    explicit ViscosityFluxSum(const Coefficients& c) : rho_0(c.restDensity[0]) {}
    /// Factor of a pair's difference of q, without rho_0/m_i: negative.
    auto rate(const auto& ij, const auto& i, const auto& j) const
    {
        const double V = j.wall > 0 ? 0.0 : j.V;
        return i.V * V * ij.dWdrOverR * (i.B + j.B);
    }
};

struct ViscosityFluxResponse : ViscosityFluxSum
{
    static constexpr auto name = "viscosityFluxResponse";
    using Provides = PowderResponse;
    using Reads = Fields<Volume, ViscosityDiffusivity, PowderChange, GhostWall>;
    using ViscosityFluxSum::ViscosityFluxSum;
    auto operator()(const auto& ij, const auto& i, const auto& j) const { return rate(ij, i, j) * (i.q - j.q); }
    double finish(const auto& i, double sum) const { return rho_0 / i.m * sum; }
};

/// The rate at which a particle alone would come to the phi of its neighbours, the diagonal of -K.
struct ViscosityFluxRate : ViscosityFluxSum
{
    static constexpr auto name = "viscosityFluxRate";
    using Provides = PowderRelaxation;
    using Reads = Fields<Volume, ViscosityDiffusivity, GhostWall>;
    using ViscosityFluxSum::ViscosityFluxSum;
    auto operator()(const auto& ij, const auto& i, const auto& j) const { return -rate(ij, i, j) * (ij.rr > 0); }
    double finish(const auto& i, double sum) const { return rho_0 / i.m * sum; }
};

}
