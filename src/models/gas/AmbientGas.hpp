/// Gas at a constant pressure: that of a band around the liquid (GasBand.hpp), whose outer support stands still.
///
///   p_i = p_b + (1 - s_i) (p(rho_i) - p_b)                                  s: share of the ambient gas that a particle is, 0 beside the liquid and of all else
///   dv_i/dt = -1/m_i sum_j [ q_i V_i^2 + q_j V_j^2 + V_i V_j p_b (s_j - s_i) ] gradW_ij,    q = p - s p_b
///   V_i = m_i/rho_0,  N_i = that of a cubic lattice,  v_i = 0               of gas that stands still; of all others V and N (operators/KernelMoment.hpp) as ever
///
/// With the background pressure p_b alone uniform gas is a lattice, by the force of Hu and Adams, whose stiffness against shear is of the order of p_b: between a liquid and what stands it is a
/// spring. The force above has no p_b where s is 1; the gradient of s p_b is taken as differences have it, 0 where s is uniform however the particles lie. It is that of Hu and
/// Adams where s is 0. What stands still ends the gas: its own sums, which lack neighbours, are not used.
///
/// Of these calm gas (CalmGas.hpp) takes the force alone, with pressures of the state equation.
///
/// p [Pa], V [m^3], v [m/s]. Verified by test/unit/gas.
#pragma once
#include "models/density/NumberDensity.hpp"
#include "models/pressure/Tait.hpp"
#include "operators/KernelMoment.hpp"

namespace sph
{

/// 0 of all that a state equation alone gives a pressure, 1 + s of gas that moves, 3 of that which stands still.
struct Ambient
{
    static constexpr FieldInfo info{"ambient", "1"};
    static constexpr double stands = 3;
    static constexpr double moving(double share) { return 1 + share; }
    static constexpr bool isMoving(double ambient) { return ambient > 0 && ambient < stands; }
    /// s
    template<class Real> static Real share(Real ambient) { return fmax(Real(0), fmin(Real(1), ambient - 1)); }
    template<int dim, class Real = double> struct At
    {
        Real ambient;
    };
};

/// Numbers of the gas at rest.
struct GasAtRest
{
    double density = 1; ///< rho_0 [kg/m^3]
    double moment = 1;  ///< M of the kernel on a cubic lattice [1/m^d]

    static GasAtRest of(double density, const std::string& kernel, int dimension, double H, double spacing);
};

struct NumberDensityOrRest : NumberDensity
{
    static constexpr auto name = "numberDensityOrRest";
    using ReadsOwn = Fields<Mass, Ambient>;
    double restDensity;

    explicit NumberDensityOrRest(const Coefficients& c) : NumberDensity(c), restDensity(c.has<GasAtRest>() ? c.of<GasAtRest>().density : 1)
    {}
    auto finish(const auto& i, double sum) const
    {
        return i.ambient == Ambient::stands ? i.m / restDensity : NumberDensity::finish(i, sum);
    }
};

/// N_i
struct GradientNormalisationOrRest : GradientNormalisation
{
    static constexpr auto name = "gradientNormalisationOrRest";
    using ReadsOwn = Fields<KernelMoment, Volume, Ambient>;
    double atRest;

    explicit GradientNormalisationOrRest(const Coefficients& c) : atRest(c.has<GasAtRest>() ? c.of<GasAtRest>().moment : 1) {}
    auto operator()(const auto& i) const { return i.ambient == Ambient::stands ? atRest * i.V : GradientNormalisation::operator()(i); }
};

struct AmbientPressure
{
    static constexpr auto name = "ambientPressure";
    using Adds = Acceleration;
    using Reads = Fields<Pressure, Volume, Ambient>;
    using ReadsOwn = Fields<Mass>;
    static constexpr bool bearsSingle = true;
    double p_b;

    explicit AmbientPressure(const Coefficients& c) : p_b(c.backgroundPressure) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const auto b_i = p_b * Ambient::share(i.ambient), b_j = p_b * Ambient::share(j.ambient);
        return -1 / i.m * ((i.p - b_i) * sqr(i.V) + (j.p - b_j) * sqr(j.V) + i.V * j.V * (b_j - b_i)) * ij.gradW;
    }
};

struct TaitOfPhaseOrAmbient : TaitOfPhase
{
    static constexpr auto name = "taitOfPhaseOrAmbient";
    using ReadsOwn = Fields<Density, Phase, Ambient>;
    using TaitOfPhase::TaitOfPhase;
    auto operator()(const auto& i) const { return p_b + (1 - Ambient::share(i.ambient)) * (TaitOfPhase::operator()(i) - p_b); }
};

/// The same, but for what openings hold.
struct TaitOfPhaseOrHeldOrAmbient : TaitOfPhaseOrAmbient
{
    static constexpr auto name = "taitOfPhaseOrHeldOrAmbient";
    using ReadsOwn = Fields<Density, Phase, Ambient, Holder, HeldPressure>;
    using TaitOfPhaseOrAmbient::TaitOfPhaseOrAmbient;
    auto operator()(const auto& i) const { return isPrescribed(i) ? i.p_h : TaitOfPhaseOrAmbient::operator()(i); }
};

}
