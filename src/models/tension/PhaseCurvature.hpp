/// Surface tension by curvature between any number of phases: each phase k against all others, with the sums that CurvatureForce.hpp has for
/// the first of two,
///
///   c_k,i = sum_(j in k) V_j W_ij,    gradC_k and kappa_k from c_k as there
///
/// and a share of the tension for each phase: gamma_k + gamma_l = gamma_kl. Between k and l alone kappa_l = -kappa_k, and the force is that of two
/// phases; where three meet, each pushes by the curvature of its own corner, as Neumann's triangle wants it (Smith, Solis & Chopp 2002). Three
/// tensions always have such shares, gamma_1 = (gamma_12 + gamma_13 - gamma_23)/2; of more phases they are those of least squares, and what they miss of
/// gamma_kl is borne half and half: each interface then has its tension, the lines of contact theirs as nearly as the shares allow.
///
/// One normal for each pair of phases, from c_l gradC_k - c_k gradC_l, was not taken: contours of c_k/(c_k + c_l) have no corner where three phases meet, and
/// nothing there would know the tensions. The force as -gamma_k kappa_k gradC_k came to the same angles with 3 to 5 times the kinetic energy. Verified by
/// test/unit/tension (plain loop) and tutorials/verification/liquidLens.
#pragma once
#include "models/tension/CurvatureForce.hpp"
#include "models/tension/NearestWall.hpp"

namespace sph
{

/// The smoothed colour of a phase:
///
///   c_k,i = sum_j V_j C_k,j W_ij,    C_k,j = 1 in phase k, 0 elsewhere
struct PhaseColourSmoothing
{
    using Provides = SmoothedColour;
    using Reads = Fields<Volume, Phase>;
    static constexpr bool readsKernel = true;
    double phase; ///< k

    auto operator()(const auto& ij, const auto&, const auto& j) const { return (j.phase == phase ? 1.0 : 0.0) * j.V * ij.W; }
};

/// A gradient of colour, and the mean of the cosine over the particles of other phases: sums of one loop.
template<int dim> struct GradientAndCosine
{
    Vector<dim> gradC;
    double cosine, weight;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.gradC, q.cosine, q.weight); }
};

/// gradC_k turned to the contact angle next to a wall, as AdheringColourGradient has it: with that of phase k and what it meets there,
///
///   cos(theta) = sum_(j not in k) V_j cos(theta_k,l) W_ij / sum_(j not in k) V_j W_ij,    l the phase of j
struct AdheringPhaseGradient
{
    using Provides = ColourGradient;
    using Reads = Fields<Volume, Phase, SmoothedColour>;
    using ReadsOwn = Fields<NearestWallNormal, NearestWall>;
    static constexpr bool readsKernel = true;
    const double* cosine; ///< walls x phases: of the angle between k and each other phase, through k
    int phases;
    double phase; ///< k

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        constexpr int dim = dimensions(decltype(ij.x){});
        const double w = (j.phase == phase ? 0.0 : 1.0) * j.V * ij.W;
        return GradientAndCosine<dim>{j.V * (j.colour - i.colour) * ij.gradW, w * cosine[int(i.nearestWall) * phases + int(j.phase)], w};
    }
    auto finish(const auto& i, const auto& sum) const
    {
        struct
        {
            decltype(i.n_w) n_w;
            double cosTheta;
        } const atWall{i.n_w, sum.weight > 0 ? sum.cosine / sum.weight : 0.0};
        return AdheringColourGradient{}.finish(atWall, sum.gradC);
    }
};

/// 1 for i in phase k and j not, -1 for j in k and i not, else 0.
inline double across(double phase, const auto& i, const auto& j) { return (i.phase == phase ? 1.0 : 0.0) - (j.phase == phase ? 1.0 : 0.0); }

/// Force of one phase's curvature, in pairs across its surface:
///
///   dv_i/dt = 1/m_i sum_j s_ij gamma_k (kappa_k,i + kappa_k,j)/2 2 rho_i/(rho_i + rho_j) (V_i^2 + V_j^2)/2 gradW_ij
///
/// s_ij: `across`; gamma_k [N/m] phase k's share of the tension with the other phase of the pair.
struct PhaseCurvatureForce
{
    using Adds = Acceleration;
    using Reads = Fields<Volume, Phase, Density, Curvature>;
    using ReadsOwn = Fields<Mass>;
    const double* share; ///< [N/m], by the other phase; 0 with itself
    double phase;        ///< k

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const double gamma = share[int(i.phase == phase ? j.phase : i.phase)];
        return 0.5 * gamma * across(phase, i, j) / i.m * (i.kappa + j.kappa) * i.rho / (i.rho + j.rho) * (sqr(i.V) + sqr(j.V)) * ij.gradW;
    }
};

/// Force of the curvature beside the pressure of Hu & Adams (EvenCurvatureForce):
///
///   dv_i/dt = 1/m_i sum_j s_ij gamma_k (kappa_k,i + kappa_k,j)/2 (V_i^2 + V_j^2)/2 gradW_ij
struct EvenPhaseCurvatureForce
{
    using Adds = Acceleration;
    using Reads = Fields<Volume, Phase, Curvature>;
    using ReadsOwn = Fields<Mass>;
    const double* share; ///< [N/m], by the other phase; 0 with itself
    double phase;        ///< k

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const double gamma = share[int(i.phase == phase ? j.phase : i.phase)];
        return 0.25 * gamma * across(phase, i, j) / i.m * (i.kappa + j.kappa) * (sqr(i.V) + sqr(j.V)) * ij.gradW;
    }
};

}
