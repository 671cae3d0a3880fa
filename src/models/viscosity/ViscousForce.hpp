/// Acceleration by viscosity. The mean viscosity of a pair is a policy: harmonic between phases, one constant in a single phase.
#pragma once
#include "base/sumOfSquares.hpp"
#include "fields/fieldTags.hpp"
#include "plan/Coefficients.hpp"
#include <algorithm>

namespace sph
{

/// A sum under the name of a term.
template<std::size_t n> struct TermName
{
    char text[n];
    constexpr TermName(const char (&of)[n]) { std::copy_n(of, n, text); }
};
template<TermName term, class Sum> struct Named : Sum
{
    static constexpr auto name = term.text;
    using Sum::Sum;
};

/// One viscosity everywhere: no field, no column.
struct UniformViscosity
{
    template<class... Other> using Reads = Fields<Volume, Other...>;
    double mu; ///< [Pa s]

    explicit UniformViscosity(const Coefficients& c) : mu(c.viscosity[0]) {}
    auto operator()(const auto&, const auto&) const { return mu; }
};

/// Viscosity of a pair of two phases:
///
///   mu_ij = 2 mu_i mu_j/(mu_i + mu_j)
///
/// It makes the shear stress continuous across an interface. The smallest number keeps 0/0 away.
struct HarmonicMean
{
    template<class... Other> using Reads = Fields<Volume, Other..., DynamicViscosity>;
    explicit HarmonicMean(const Coefficients&) {}
    auto operator()(const auto& i, const auto& j) const { return 2 * i.mu * j.mu / (i.mu + j.mu + smallest(i.mu)); }
};

/// mu_i of the particle's phase [Pa s].
struct ViscosityOfPhase
{
    static constexpr auto name = "viscosityOfPhase";
    using Provides = DynamicViscosity;
    using ReadsOwn = Fields<Phase>;
    const double* mu;

    explicit ViscosityOfPhase(const Coefficients& c) : mu(c.viscosity.data()) {}
    auto operator()(const auto& i) const { return mu[int(i.phase)]; }
};

/// Hu & Adams (2006), eq. (10) of Barker et al. (2012):
///
///   dv_i/dt = 1/m_i sum_j mu_ij (V_i^2 + V_j^2) (dW_ij/dr)/r_ij v_ij
///
/// mu [Pa s] mean dynamic viscosity of the pair, V = 1/sigma [m^3], v_ij = v_i - v_j [m/s]. Conserves linear momentum exactly.
/// With a normalised gradient (KernelMoment.hpp) a parabola is differentiated exactly: order 2 in plane Poiseuille flow, verified by
/// tutorials/verification/planePoiseuille; without, the paper's scheme, it is 4 % low at any resolution.
template<class MeanViscosity> struct MorrisSum
{
    using ReadsOwn = Fields<Mass>;
    MeanViscosity mean;

    explicit MorrisSum(const Coefficients& c) : mean(c) {}
    /// Factor of a pair's velocity difference in its force, times a number: negative.
    auto times(auto number, const auto& ij, const auto& i, const auto& j) const
    {
        return number * mean(i, j) * sumOfSquares(i.V, j.V) * ij.dWdrOverR;
    }
};

/// Cleary & Monaghan (1999), eq. (3.4) of Kauzlaric et al. (2011), there with V = m/rho:
///
///   dv_i/dt = 1/m_i sum_j 2 mu_ij V_i V_j (dW_ij/dr)/r_ij v_ij
///           = -sum_j m_j 4 mu_i mu_j/(mu_i + mu_j) w_ij/(rho_i rho_j) v_ij,    w = -(dW/dr)/r, of the harmonic mean
///
/// The sum above less mu_ij (V_i - V_j)^2. Conserves linear momentum exactly. Verified by test/unit/viscosity (plain loop).
template<class MeanViscosity> struct ClearyMonaghanSum : MorrisSum<MeanViscosity>
{
    using MorrisSum<MeanViscosity>::MorrisSum;
    auto times(auto number, const auto& ij, const auto& i, const auto& j) const
    {
        return 2 * number * this->mean(i, j) * i.V * j.V * ij.dWdrOverR;
    }
};

template<class MeanViscosity, template<class> class Sum = MorrisSum> struct MorrisViscosity : Sum<MeanViscosity>
{
    using Reads = typename MeanViscosity::template Reads<Velocity>;
    using Adds = Acceleration;
    static constexpr bool bearsSingle = true;
    using Sum<MeanViscosity>::Sum;
    auto operator()(const auto& ij, const auto& i, const auto& j) const { return this->times(1 / i.m, ij, i, j) * (i.v - j.v); }
};

/// Monaghan & Gingold's (1983) form along the line of centres, with the viscosities of two phases as Cleary (1998) and Hu & Adams have them:
///
///   dv_i/dt = 1/m_i sum_j (d + 2) mu_ij (V_i^2 + V_j^2) (dW_ij/dr)/r_ij (v_ij . x_ij)/r_ij^2 x_ij
///
/// d dimensions. The divergence of the whole stress mu (grad v + (grad v)^T + div v I), where Morris' form is div(mu grad v): the two differ where
/// mu does, at the surface of a liquid in a thin gas. There Morris' form leaves half of the dissipation of a potential flow out, and an oscillating
/// drop decays too slowly (tutorials/verification/oscillatingDrop). Conserves linear and angular momentum exactly. Its compression is resisted
/// by 3 mu, so that the step by viscosity is a third. Erratum of Kauzlaric et al. (2011), eq. (2.1): div(mu grad v) is the viscous force of unidirectional flow
/// alone; in a mould it is that of the whole stress. On a square lattice it is not isotropic: 11 % too stiff along the axes at a support of 3
/// spacings of wendlandC2, 4 % at 4.
template<class MeanViscosity> struct CentralSum : MorrisSum<MeanViscosity>
{
    using MorrisSum<MeanViscosity>::MorrisSum;
    auto along(auto number, const auto& ij, const auto& i, const auto& j, auto v_ij) const
    {
        return (dimensions(ij.x) + 2) * this->times(number, ij, i, j) * dot(v_ij, ij.x) / (ij.rr + smallest(ij.rr)) * ij.x;
    }
};

template<class MeanViscosity> struct CentralViscosity : CentralSum<MeanViscosity>
{
    using Reads = typename MeanViscosity::template Reads<Velocity>;
    using Adds = Acceleration;
    static constexpr bool bearsSingle = true;
    using CentralSum<MeanViscosity>::CentralSum;
    auto operator()(const auto& ij, const auto& i, const auto& j) const { return this->along(1 / i.m, ij, i, j, i.v - j.v); }
};

using SinglePhaseViscosity = Named<"singlePhaseViscosity", MorrisViscosity<UniformViscosity>>;
using HarmonicViscosity = Named<"harmonicViscosity", MorrisViscosity<HarmonicMean>>;
using SinglePhaseClearyMonaghanViscosity =
    Named<"singlePhaseClearyMonaghanViscosity", MorrisViscosity<UniformViscosity, ClearyMonaghanSum>>;
using ClearyMonaghanViscosity = Named<"clearyMonaghanViscosity", MorrisViscosity<HarmonicMean, ClearyMonaghanSum>>;
using SinglePhaseClearyViscosity = Named<"singlePhaseClearyViscosity", CentralViscosity<UniformViscosity>>;
using ClearyViscosity = Named<"clearyViscosity", CentralViscosity<HarmonicMean>>;

/// Response of viscosity for the implicit step (integrators/ImplicitSolve): the same sum over a change of the velocity.
template<class MeanViscosity, template<class> class Sum = MorrisSum> struct MorrisResponse : Sum<MeanViscosity>
{
    using Reads = typename MeanViscosity::template Reads<VelocityChange>;
    using Provides = ViscousResponse;
    using Sum<MeanViscosity>::Sum;
    static constexpr bool bearsSingle = true;
    auto operator()(const auto& ij, const auto& i, const auto& j) const { return this->times(1, ij, i, j) * (i.dv - j.dv); }
    auto finish(const auto& i, const auto& sum) const { return 1 / i.m * sum; }
};
using SinglePhaseResponse = Named<"singlePhaseViscousResponse", MorrisResponse<UniformViscosity>>;
using HarmonicResponse = Named<"harmonicViscousResponse", MorrisResponse<HarmonicMean>>;
using SinglePhaseClearyMonaghanResponse =
    Named<"singlePhaseClearyMonaghanViscousResponse", MorrisResponse<UniformViscosity, ClearyMonaghanSum>>;
using ClearyMonaghanResponse = Named<"clearyMonaghanViscousResponse", MorrisResponse<HarmonicMean, ClearyMonaghanSum>>;
template<class MeanViscosity> struct CentralResponse : CentralSum<MeanViscosity>
{
    using Reads = typename MeanViscosity::template Reads<VelocityChange>;
    using Provides = ViscousResponse;
    using CentralSum<MeanViscosity>::CentralSum;
    static constexpr bool bearsSingle = true;
    auto operator()(const auto& ij, const auto& i, const auto& j) const { return this->along(1, ij, i, j, i.dv - j.dv); }
    auto finish(const auto& i, const auto& sum) const { return 1 / i.m * sum; }
};
using SinglePhaseClearyResponse = Named<"singlePhaseClearyResponse", CentralResponse<UniformViscosity>>;
using ClearyResponse = Named<"clearyResponse", CentralResponse<HarmonicMean>>;

/// The rate at which a particle alone would come to rest among its neighbours [1/s]:
///
///   lambda_i = -sum_j rate_ij,    dv_i/dt = sum_j rate_ij v_ij
///
/// Along the line of centres it is (d + 2)/d times that, the mean over directions.
template<class MeanViscosity, template<class> class Sum = MorrisSum> struct MorrisRate : Sum<MeanViscosity>
{
    using Reads = typename MeanViscosity::template Reads<>;
    using Provides = ViscousRate;
    static constexpr bool bearsSingle = true;
    using Sum<MeanViscosity>::Sum;
    auto operator()(const auto& ij, const auto& i, const auto& j) const { return ij.ofOther(-this->times(1 / i.m, ij, i, j)); }
};
using SinglePhaseRate = Named<"singlePhaseViscousRate", MorrisRate<UniformViscosity>>;
using HarmonicRate = Named<"harmonicViscousRate", MorrisRate<HarmonicMean>>;
using SinglePhaseClearyMonaghanRate = Named<"singlePhaseClearyMonaghanViscousRate", MorrisRate<UniformViscosity, ClearyMonaghanSum>>;
using ClearyMonaghanRate = Named<"clearyMonaghanViscousRate", MorrisRate<HarmonicMean, ClearyMonaghanSum>>;
template<class MeanViscosity> struct CentralRate : MorrisRate<MeanViscosity>
{
    using MorrisRate<MeanViscosity>::MorrisRate;
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        constexpr double d = dimensions(decltype(ij.x){});
        return (d + 2) / d * MorrisRate<MeanViscosity>::operator()(ij, i, j);
    }
};
using SinglePhaseClearyRate = Named<"singlePhaseClearyRate", CentralRate<UniformViscosity>>;
using ClearyRate = Named<"clearyRate", CentralRate<HarmonicMean>>;

}
