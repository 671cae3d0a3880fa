/// The response of the pressure that an implicit step asks for (integrators/ImplicitSolve): its force changes when particles move by dt u.
///
///   dF_i = -dt sum_j [ (q_i + q_j) gradW_ij - g_ij (u_i - u_j) ],    q_k = a_k sum_j gradW_kj.(u_k - u_j),    a_k = V_k^2 dp/dsigma
///   g_ij = max(0, p_i V_i^2 + p_j V_j^2) (dW_ij/dr)/r_ij
///
/// The first part is how pressures change with the number density sigma = 1/V, in the force of Hu & Adams (2006): dF.u = -dt sum_k a_k s_k^2 <= 0 of
/// the sum s_k in q_k, the Hessian of their energy but for what the pair distances change at given pressures. That remainder has
/// both signs; g bounds it from above. Without it a background pressure p_b above rho c^2 of the gas makes steps unstable that are longer
/// than its own waves of speed sqrt(p_b/rho) allow.
///
/// For one particle that moves alone on a square or cubic lattice, wendlandC2 with a support of 3 spacings, the remainder is 8.7 or 11.7 p/(rho c^2) times what
/// is kept, and g is 27 or 85 p/(rho c^2) times it: little in a liquid, but 24 times in the gas of a drop whose p_b is 2.8 rho c^2
/// (tutorials/stiff/dropOffLattice). It makes the matrix stiffer than the fluid and not the step less exact: an inexact matrix leaves the order.
///
/// u [m/s] with the mirror images of a displacement, whatever the wall does to velocities. V [m^3], p [Pa], m [kg].
#pragma once
#include "fields/fieldTags.hpp"
#include "plan/Coefficients.hpp"
#include <cmath>

namespace sph
{

/// Stiffness of a particle's volume:
///
///   a = V^2 dp/dsigma = V^2 m dp/drho
struct StiffnessOfPhase
{
    static constexpr auto name = "volumeStiffness";
    using Provides = VolumeStiffness;
    using ReadsOwn = Fields<Mass, Volume, Density, Phase>;
    const StateEquation* equation;

    explicit StiffnessOfPhase(const Coefficients& c) : equation(c.stateEquation.data()) {}
    auto operator()(const auto& i) const { return sqr(i.V) * i.m * equation[int(i.phase)].slope(i.rho); }
};
struct UniformStiffness
{
    static constexpr auto name = "uniformVolumeStiffness";
    using Provides = VolumeStiffness;
    using ReadsOwn = Fields<Mass, Volume, Density>;
    StateEquation equation;

    explicit UniformStiffness(const Coefficients& c) : equation(c.stateEquation[0]) {}
    auto operator()(const auto& i) const { return sqr(i.V) * i.m * equation.slope(i.rho); }
};

/// P = p V^2, of which the force of a pair is made.
struct StrengthOfPressure
{
    static constexpr auto name = "pressureStrength";
    using Provides = PressureStrength;
    using ReadsOwn = Fields<Pressure, Volume>;
    auto operator()(const auto& i) const { return i.p * sqr(i.V); }
};

struct ChangeAsDisplacement
{
    static constexpr auto name = "changeAsDisplacement";
    using Provides = Displacement;
    using ReadsOwn = Fields<VelocityChange>;
    auto operator()(const auto& i) const { return i.dv; }
};

/// q_i
struct CompressionOfChange
{
    static constexpr auto name = "compressionOfChange";
    using Provides = CompressionChange;
    using Reads = Fields<Displacement>;
    using ReadsOwn = Fields<VolumeStiffness>;
    static constexpr bool bearsSingle = true;
    auto operator()(const auto& ij, const auto& i, const auto& j) const { return dot(ij.gradW, i.u - j.u); }
    auto finish(const auto& i, double sum) const { return i.a * sum; }
};

/// Repulsion of a pair: its force over its distance, per dW/dr/r, and 0 where it attracts.
inline auto repulsion(const auto& i, const auto& j) { return fmax(decltype(i.P + j.P){}, i.P + j.P); }

/// The part of g in dF_i/(m_i dt). It goes with the sum in q, of whose numbers it reads but one more: what is left for the sum over q then gathers nothing but q.
struct RepulsionOfChange
{
    static constexpr auto name = "repulsionOfChange";
    using Adds = StiffResponse;
    using Reads = Fields<Displacement, PressureStrength>;
    using ReadsOwn = Fields<Mass>;
    static constexpr bool bearsSingle = true;
    auto operator()(const auto& ij, const auto& i, const auto& j) const { return repulsion(i, j) * ij.dWdrOverR * (i.u - j.u); }
    auto finish(const auto& i, const auto& sum) const { return 1 / i.m * sum; }
};

/// The part of q.
struct PressureResponse
{
    static constexpr auto name = "pressureResponse";
    using Adds = StiffResponse;
    using Reads = Fields<CompressionChange>;
    using ReadsOwn = Fields<Mass>;
    static constexpr bool bearsSingle = true;
    auto operator()(const auto& ij, const auto& i, const auto& j) const { return (i.q + j.q) * ij.gradW; }
    auto finish(const auto& i, const auto& sum) const { return -1 / i.m * sum; }
};

/// The diagonal of that, mean over directions [1/s^2]:
///
///   kappa_i = 1/(d m_i) [a_i |sum_j gradW_ij|^2 + sum_j a_j |gradW_ij|^2] - 1/m_i sum_j g_ij
template<int dim, class Real> struct DiagonalSums
{
    Vector<dim, Real> slope;
    Real ofOthers;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.slope, q.ofOthers); }
};
struct PressureRate
{
    static constexpr auto name = "pressureRate";
    using Provides = StiffRate;
    using Reads = Fields<VolumeStiffness, PressureStrength>;
    using ReadsOwn = Fields<Mass>;
    static constexpr bool bearsSingle = true;
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        constexpr int dim = dimensions(decltype(ij.x){});
        return DiagonalSums<dim, decltype(ij.rr)>{ij.gradW,
                                                  j.a * dot(ij.gradW, ij.gradW) - ij.ofOther(dim * repulsion(i, j) * ij.dWdrOverR)};
    }
    auto finish(const auto& i, const auto& sum) const
    {
        return (i.a * dot(sum.slope, sum.slope) + sum.ofOthers) / (dimensions(decltype(sum.slope){}) * i.m);
    }
};

}
