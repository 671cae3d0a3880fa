/// The transposed part of the viscous stress, which Morris' sum leaves out: div(mu grad v) + div(mu (grad v)^T) is the divergence of mu (grad v + (grad v)^T).
///
///   A_i = sum_j V_j mu_ij (v_j - v_i) gradW_ij,    b_i = largest eigenvalue of -sum_j V_j mu_ij x_ij gradW_ij,    G_i = A_i/b_i
///   dv_i/dt = V_i/m_i sum_j V_j mu_ij (G_i^T + G_j^T) gradW_ij
///
/// mu_ij [Pa s] mean viscosity of the pair, V [m^3], v [m/s], A [Pa], b [Pa s], G [1/s] the velocity gradient as the stress has it: inside a phase
/// grad v, at the surface of a liquid in a thin gas that of the liquid alone. Where mu is the same all around the sum is mu grad div v, nothing that a
/// liquid would notice; where it jumps it is the half of the stress that lets a free surface move like one (tutorials/verification/oscillatingDrop).
///
/// The force is minus the derivative of sum_i V_i b_i G_i:G_i^T/2 by v_i: pairs cancel, so that linear momentum is conserved exactly. Since
/// V_i b_i |G_i|^2 <= sum_j mu_ij V_i V_j |dW/dr|/r |v_ij|^2 (Cauchy and Schwarz; the reason for the largest eigenvalue), it never gives more than
/// Morris' sum takes: together they lose energy in any motion and for any positions, turning like a solid costs nothing, and
/// (1 - dt L) v_1 = (1 + dt T) v_0, Morris' L implicit and this T explicit, is stable at any step. The step by explicit viscosity stays as well: at short
/// waves, which limit it, G vanishes. Verified by test/unit/viscosity (plain loop, momentum, energy, solid rotation).
#pragma once
#include "base/Tensor.hpp"
#include "models/viscosity/ViscousForce.hpp"

namespace sph
{

template<int dim, class Real> struct GradientAndMoment
{
    Tensor<dim, Real> A;
    SymmTensor<dim, Real> moment;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.A, q.moment); }
};

template<class MeanViscosity> struct GradientOfStress
{
    using Provides = ViscousGradient;
    using Reads = typename MeanViscosity::template Reads<Velocity>;
    static constexpr bool bearsSingle = true;
    MeanViscosity mean;

    explicit GradientOfStress(const Coefficients& c) : mean(c) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        constexpr int dim = dimensions(decltype(ij.x){});
        const auto w = j.V * mean(i, j);
        return GradientAndMoment<dim, decltype(ij.rr)>{w * outer(j.v - i.v, ij.gradW), -w * ij.dWdrOverR * outer(ij.x)};
    }
    auto finish(const auto&, const auto& sum) const
    {
        const double b = -leastEigenvalue(-1.0 * sum.moment);
        return (b > 0 ? 1 / b : 0.0) * sum.A;
    }
};

template<class MeanViscosity> struct TransposedSum
{
    using Adds = Acceleration;
    using Reads = typename MeanViscosity::template Reads<ViscousGradient>;
    using ReadsOwn = Fields<Mass>;
    static constexpr bool bearsSingle = true;
    MeanViscosity mean;

    explicit TransposedSum(const Coefficients& c) : mean(c) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return i.V / i.m * j.V * mean(i, j) * (transpose(i.G + j.G) * ij.gradW);
    }
};

using ViscousGradientOfPhases = Named<"viscousGradient", GradientOfStress<HarmonicMean>>;
using TransposedViscosity = Named<"transposedViscosity", TransposedSum<HarmonicMean>>;
using SinglePhaseViscousGradient = Named<"singlePhaseViscousGradient", GradientOfStress<UniformViscosity>>;
using SinglePhaseTransposedViscosity = Named<"singlePhaseTransposedViscosity", TransposedSum<UniformViscosity>>;

}
