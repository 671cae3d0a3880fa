/// Acceleration by a stress, shared by all models that have one (surface tension, soil).
///
///   dv_i/dt = 1/m_i sum_j (S_i V_i^2 + S_j V_j^2) . gradW_ij
///
/// S [Pa] tension positive, V [m^3], m [kg]. Conserves linear momentum exactly. Verified by test/unit/tension (plain loop, momentum). Erratum of Peng et al. (2014),
/// eqs. (7) and (10): they hold for stresses that are positive in tension, though the text has compression positive; the force is the divergence of the stress, and eq. (10) lacks gravity.
#pragma once
#include "operators/VelocityGradient.hpp"

namespace sph
{

template<class OfStress> struct DivergenceOf
{
    using Adds = Acceleration;
    using Reads = Fields<OfStress, Volume>;
    using ReadsOwn = Fields<Mass>;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return 1 / i.m * ((sqr(i.V) * i.S + sqr(j.V) * j.S) * ij.gradW); }
};
struct StressDivergence : DivergenceOf<Stress>
{
    static constexpr auto name = "stressDivergence";
};

/// Acceleration by a stress: the form of differences where the kernel is whole, and the symmetric form at surfaces, with its natural boundary condition S n = 0:
///
///   dv_i/dt = w_i V_i/m_i sum_j V_j (S_j - S_i) . L_i gradW_ij + (1 - w_i)/m_i sum_j (S_i V_i^2 + S_j V_j^2) . gradW_ij
///
/// w that of the corrected velocity gradient (VelocityGradient.hpp). The first is exact for a stress that is linear, however the particles lie: a uniform one moves nothing. Momentum is conserved to the
/// order of the scheme alone, and nothing keeps particles even: for quasi-static loading. Verified by test/unit/soil (order).
template<class OfStress> struct DifferenceDivergenceOf
{
    using Adds = Acceleration;
    using Reads = Fields<OfStress, Volume>;
    using ReadsOwn = Fields<Mass, CorrectionTensor, LeastEigenvalue>;
    static constexpr bool ofRawGradient = true;
    CorrectedFrom corrected;

    explicit DifferenceDivergenceOf(const Coefficients& c) : corrected(correctedFrom(c)) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return corrected.share(i.lambda) * i.V / i.m * j.V * ((j.S - i.S) * (i.L * ij.gradW));
    }
};
template<class OfStress> struct SurfaceDivergenceOf : DivergenceOf<OfStress>
{
    using ReadsOwn = Fields<Mass, LeastEigenvalue>;
    CorrectedFrom corrected;

    explicit SurfaceDivergenceOf(const Coefficients& c) : corrected(correctedFrom(c)) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return (1 - corrected.share(i.lambda)) * DivergenceOf<OfStress>::operator()(ij, i, j);
    }
};

/// The pair's stress weighed by the densities, as the density-weighted pressure weighs p (S = -p I gives that form):
///
///   dv_i/dt = 1/m_i sum_j (V_i^2 + V_j^2) (rho_j S_i + rho_i S_j)/(rho_i + rho_j) . gradW_ij
///
/// Across an interface of 1000:1 the light side then does not carry the heavy side's stress: the wall tension of a liquid, which the plain
/// form hands on to the gas beside the contact line, accelerated that gas to tens of metres a second in a bed of 1 mm spheres.
struct DensityWeightedStressDivergence
{
    static constexpr auto name = "densityWeightedStressDivergence";
    using Adds = Acceleration;
    using Reads = Fields<Stress, Volume, Density>;
    using ReadsOwn = Fields<Mass>;

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return (sqr(i.V) + sqr(j.V)) / (i.m * (i.rho + j.rho)) * ((j.rho * i.S + i.rho * j.S) * ij.gradW);
    }
};

}
