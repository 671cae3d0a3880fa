/// Surface tension by curvature (CSF, Brackbill et al. 1992), between two phases: four sums, each an equation of its own.
///
/// Beside the stress form it converges at fixed support, and with the density-weighted pressure it allows the same sound speed in both
/// phases at a density ratio of 1000. It does not conserve momentum exactly. Verified by tutorials/verification/laplaceDrop.
#pragma once
#include "fields/fieldTags.hpp"
#include "models/tension/Tensions.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

/// The smoothed colour of the first phase:
///
///   c_i = sum_j V_j C_j W_ij,    C_j = 1 in the first phase, 0 in the second
struct ColourSmoothing
{
    static constexpr auto name = "colourSmoothing";
    using Provides = SmoothedColour;
    using Reads = Fields<Volume, Phase>;
    static constexpr bool bearsSingle = true;
    static constexpr bool readsKernel = true;

    auto operator()(const auto& ij, const auto&, const auto& j) const { return j.V * (1 - j.phase) * ij.W; }
};

/// Whether a particle of the second phase has no neighbour of the first: its colour is 0 to the last bit.
inline bool isFarFromFirst(const auto& i) { return i.phase > 0 && i.colour == 0; }

/// Its gradient, into the first phase [1/m]:
///
///   gradC_i = sum_j V_j (c_j - c_i) gradW_ij
struct SmoothedColourGradient
{
    static constexpr auto name = "smoothedColourGradient";
    using Provides = ColourGradient;
    using Reads = Fields<Volume, SmoothedColour>;
    static constexpr bool bearsSingle = true;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return j.V * (j.colour - i.colour) * ij.gradW; }
};

/// Colour gradient turned to the contact angle theta next to a wall (Brackbill et al. 1992: wall adhesion; Breinlinger et al. 2013 in SPH):
///
///   gradC_i = |gradC| (sin(theta) t - cos(theta) n_w),    t = (I - n_w n_w) gradC/|(I - n_w n_w) gradC|
///
/// n_w [-] normal of the wall (WallAdhesion.hpp), zero away from walls. An interface that stands at theta has no curvature at the wall; any
/// other has the curvature between its own direction and this one, whose force carries the line of contact along.
struct AdheringColourGradient : SmoothedColourGradient
{
    static constexpr auto name = "adheringColourGradient";
    using ReadsOwn = Fields<WallNormal, WallCosine>;

    auto finish(const auto& i, const auto& gradC) const
    {
        const double atWall = dot(i.n_w, i.n_w), tiny = 1e-300;
        const auto along = gradC - dot(gradC, i.n_w) * i.n_w;
        const double sine = std::sqrt(1 - sqr(i.cosTheta));
        return (1 - atWall) * gradC + atWall * mag(gradC) * (sine / (mag(along) + tiny) * along - i.cosTheta * i.n_w);
    }
};

/// Two symmetric tensors that one loop sums.
template<int dim, class Real> struct TensorPair
{
    SymmTensor<dim, Real> a, b;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.a, q.b); }
};

/// Curvature of the interface, sums over particles that have a normal:
///
///   kappa_i = div n = [sum_j V_j (n_j - n_i) gradW_ij] : [sum_j V_j (x_j - x_i) gradW_ij]^-1,    n = gradC/|gradC|
///
/// Normals shorter than 0.01/H mean no interface. The inverse makes the divergence exact for linear n although
/// the sum runs over the band alone: with a scalar in its place kappa was 4 to 8 % too large on the outside of a drop, and the pressure
/// jump 3 % at 16 spacings a radius. Where the band is too thin for it (determinant below 0.05) there is no curvature, and none beyond
/// one over the spacing, which no arrangement of particles can show.
struct InterfaceCurvature
{
    static constexpr auto name = "interfaceCurvature";
    using Provides = RawCurvature;
    using Reads = Fields<Volume, ColourGradient>;
    static constexpr bool bearsSingle = true;
    double least, most;

    explicit InterfaceCurvature(const Coefficients& c) : least(0.01 / c.support), most(1 / c.spacing) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        constexpr int dim = dimensions(decltype(ij.x){});
        const auto g_i = mag(i.gradC), g_j = mag(j.gradC);
        const auto present = g_i > least && g_j > least ? decltype(g_i){1} : decltype(g_i){};
        const auto n_j = 1 / (g_j + smallest(g_j)) * j.gradC, n_i = 1 / (g_i + smallest(g_i)) * i.gradC;
        const auto w = present * j.V;
        return TensorPair<dim, decltype(ij.rr)>{w * symm(n_j - n_i, ij.gradW), -w * ij.dWdrOverR * outer(ij.x)};
    }
    bool isNothingAt(const auto& i) const { return mag(i.gradC) < 0.999 * least; } // whatever the precision of the sum
    auto finish(const auto&, const auto& sum) const
    {
        const double det = determinant(sum.b);
        const double kappa = det > 0.05 ? doubleDot(sum.a, adjugate(sum.b)) / det : 0.0;
        return std::fmax(-most, std::fmin(most, kappa));
    }
};

/// The curvature smoothed, the sharpest parts of the band with the largest weight:
///
///   kappa_i = sum_j V_j |gradC_j| kappa_j W_ij / sum_j V_j |gradC_j| W_ij
struct CurvatureSmoothing
{
    static constexpr auto name = "curvatureSmoothing";
    using Provides = Curvature;
    using Reads = Fields<Volume, ColourGradient, RawCurvature>;
    using ReadsOwn = Fields<Phase, SmoothedColour>;
    static constexpr bool bearsSingle = true;
    static constexpr bool readsKernel = true;

    auto operator()(const auto& ij, const auto&, const auto& j) const
    {
        return j.V * mag(j.gradC) * ij.W * Vector<2, decltype(ij.W)>{j.rawKappa, 1.0};
    }
    /// Nobody asks for the curvature where the first phase is beyond two supports; beyond one, an image behind a curved wall may lie nearer to it.
    bool isNothingAt(const auto& i) const { return isFarFromFirst(i) && dot(i.gradC, i.gradC) == 0; }
    auto finish(const auto&, Vector<2> sum) const { return sum.y > 0 ? sum.x / sum.y : 0.0; }
};

/// The capillary pressure jump as each side of a pair across the interface sees it:
///
///   dv_i/dt = 1/m_i sum_(j of the other phase) s_i gamma (kappa_i + kappa_j)/2 2 rho_i/(rho_i + rho_j) (V_i^2 + V_j^2)/2 gradW_ij
///
/// s_i = 1 in the first phase, -1 in the second. The sum is that of the density-weighted pressure over the same pairs: a drop with the
/// pressure jump gamma kappa is then at rest exactly, whatever the density ratio. With the smoothed gradC in place of the pairs the force
/// and the pressure act at different depths of the interface, which made the jump 4 % of 16 spacings a radius too large at 1000:1, and
/// first order in spacing over radius.
struct CurvatureForce
{
    static constexpr auto name = "curvatureForce";
    using Adds = Acceleration;
    using Reads = Fields<Volume, Phase, Density, Curvature>;
    using ReadsOwn = Fields<Mass, SmoothedColour>;
    static constexpr bool bearsSingle = true;
    double gamma; ///< [N/m]

    explicit CurvatureForce(const Coefficients& c) : gamma(c.phases.size() == 2 ? tensionsOf(c).between[1] : 0) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const auto across = j.phase - i.phase; // s_i for pairs across the interface, 0 for all others
        return 0.5 * gamma * across / i.m * (i.kappa + j.kappa) * i.rho / (i.rho + j.rho) * (sqr(i.V) + sqr(j.V)) * ij.gradW;
    }
    bool isNothingAt(const auto& i) const { return isFarFromFirst(i); }
};

/// Force of the curvature beside the pressure of Hu & Adams, whose sum both sides share alike: so do they the force of a pair,
///
///   dv_i/dt = 1/m_i sum_(j of the other phase) s_i gamma (kappa_i + kappa_j)/2 (V_i^2 + V_j^2)/2 gradW_ij
///
/// Borne by the denser side alone it acts inside a drop, where the area is smaller: the jump of one of 8 and 16 spacings to the radius is then 7.6
/// and 2.7 % too large at 1000:1, in place of 1.3 and 0.3, and around a bubble currents remain (tutorials/stiff/dropOffLattice). As an impulse
/// once in a step of several parts it would throw a light gas about.
struct EvenCurvatureForce
{
    static constexpr auto name = "evenCurvatureForce";
    using Adds = Acceleration;
    using Reads = Fields<Volume, Phase, Curvature>;
    using ReadsOwn = Fields<Mass, SmoothedColour>;
    static constexpr bool bearsSingle = true;
    double gamma; ///< [N/m]

    explicit EvenCurvatureForce(const Coefficients& c) : gamma(c.phases.size() == 2 ? tensionsOf(c).between[1] : 0) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const auto across = j.phase - i.phase; // s_i for pairs across the interface, 0 for all others
        return 0.25 * gamma * across / i.m * (i.kappa + j.kappa) * (sqr(i.V) + sqr(j.V)) * ij.gradW;
    }
    bool isNothingAt(const auto& i) const { return isFarFromFirst(i); }
};

}
