/// What seeps into a particle, by the sum that makes the flux of scalars (ScalarFlux.hpp), and what passes free surfaces.
///
///   div(k_r (grad p - rho_w g))_i = 1/V_i sum_j w_ij k_ij (p_j - p_i + rho_w g.x_ij) [- k_i alpha_i (p_i - p_t)],    w_ij = -(V_i^2 + V_j^2) (dW_ij/dr)/r_ij/N
///
/// k_ij = (k_i + k_j)/2 of the relative permeabilities, 1 in full pores. Water at rest has no flux between any two particles, however they lie.
/// N is the second moment of the slope on a lattice (KernelMoment.hpp), the same everywhere: with that of each particle, which falls to 0.6 at a surface, the outermost rows conducted too well, and rates of
/// consolidation were 2 % off at 32 particles across, of first order. Pairs exchange what they lose, and the matrix is symmetric with the weights V. Where the soil ends the sum lacks neighbours, and sees no flux: nothing passes.
/// Where p is p_o on a free surface (OuterWater.hpp; 0 in air) it goes on linearly through it, at the depth d_i of the particle,
///
///   alpha_i = |sum_j w_ij x_ji|/(V_i d_i),    p_t = p_o(x_s) - rho_w g.(x_s - x_i),    x_s = x_i + d_i n_i
///
/// by which the sum is 0 for a p that is linear in the depth, however the particles lie: the neighbours that are missing have the first moment that the others lack. d from the first moment of the raw slope (LatticeSums),
/// and only beside particles of the surface: a lattice in disorder has first moments, too. n points along the missing neighbours. Unsaturated soil in air lets water out, where p_i > p_t, and none in: a face that seeps ends
/// where the water table leaves it, at the p of the step before. A grain that has left the soil, lambda below 0.1, has p_o of its own place all around it, alpha = sum of w/V on a lattice: what is torn apart would keep the
/// suction of that moment for good.
///
/// p [Pa], V [m^3], W [1/m^3], alpha [1/m^2], k_r [1]. Verified by test/unit/soil (linear and quadratic pressures below a surface; conservation).
#pragma once
#include "models/soil/OuterWater.hpp"
#include "models/soil/PoreWater.hpp"
#include "models/soil/SoilFields.hpp"
#include "operators/GradientCorrection.hpp"
#include "operators/VelocityGradient.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

// clang-format off
struct SurfaceRow        { static constexpr FieldInfo info{"surfaceRow", "1"};                        template<int dim, class Real = double> struct At { Real isSurface; }; };
struct KernelSlope       { static constexpr FieldInfo info{"kernelSlope", "1/m"};                     template<int dim, class Real = double> struct At { Real m_1; }; };
struct PoreLaplacian     { static constexpr FieldInfo info{"porePressureLaplacian", "Pa/m^2"};        template<int dim, class Real = double> struct At { Real lap; }; };
struct LaplacianOfChange { static constexpr FieldInfo info{"porePressureChangeLaplacian", "Pa/m^2"};  template<int dim, class Real = double> struct At { Real lap; }; };
struct SurfaceDrainage   { static constexpr FieldInfo info{"surfaceDrainage", "1/m^2"};               template<int dim, class Real = double> struct At { Real alpha; }; };
/// Free surfaces let pass k alpha (p - p_t), or nothing: the two factors.
struct SurfaceOutflow    { static constexpr FieldInfo info{"surfaceOutflow", "1/m^2"};                template<int dim, class Real = double> struct At { Real outflow; }; };
struct SurfaceTarget     { static constexpr FieldInfo info{"surfaceTarget", "Pa"};                    template<int dim, class Real = double> struct At { Real p_t; }; };
struct SeepageDiagonal   { static constexpr FieldInfo info{"seepageDiagonal", "1/m^2"};               template<int dim, class Real = double> struct At { Real diagonal; }; };
/// The same sums of chi in place of k_r: what grains give way by (PoreWaterStep.hpp).
struct GrainsOfChange    { static constexpr FieldInfo info{"grainsOfPorePressureChange", "Pa/m^2"};   template<int dim, class Real = double> struct At { Real ofGrains; }; };
struct GrainDiagonal     { static constexpr FieldInfo info{"grainDiagonal", "1/m^2"};                 template<int dim, class Real = double> struct At { Real ofGrains; }; };
struct SeepageVelocity   { static constexpr FieldInfo info{"seepageVelocity", "m/s", Image::mirrored}; template<int dim, class Real = double> struct At { Vector<dim, Real> q; }; };
// clang-format on

/// Values of SurfaceRow.
inline constexpr double surfaceRow = 1, loneGrain = 2;

template<int dim> struct SlopeMoments
{
    SymmTensor<dim> B;
    Vector<dim> m_1;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.B, q.m_1); }
};

/// Rows that end the soil, by the least eigenvalue of the moment tensor (FreeSurface.hpp), and the first moment |sum_j V_j (dW/dr)/r x_ij|.
struct SurfaceOfSoil
{
    static constexpr auto name = "surfaceOfSoil";
    using Provides = Fields<SurfaceRow, KernelSlope>;
    using Reads = Fields<Volume>;
    static constexpr bool ofRawGradient = true;
    /// lambda is 0.49 in the first row below a plane surface, 0.84 and more in the second, 0.8 and more in disorder.
    static constexpr double mostAtSurface = 0.7;
    static constexpr double mostOfLoneGrain = 0.1;

    auto operator()(const auto& ij, const auto&, const auto& j) const
    {
        const double w = -j.V * ij.dWdrOverR;
        return SlopeMoments<dimensions(decltype(ij.x){})>{w * outer(ij.x), -w * ij.x};
    }
    auto finish(const auto&, const auto& sum) const
    {
        const double lambda = leastEigenvalue(sum.B);
        return Values<Provides, dimensions(decltype(sum.m_1){})>{{lambda < mostOfLoneGrain ? loneGrain
                                                                  : lambda < mostAtSurface ? surfaceRow
                                                                                           : 0.0},
                                                                 {mag(sum.m_1)}};
    }
};

/// w_ij of the raw slope, and heads.
struct SeepageWeight
{
    static constexpr bool ofRawGradient = true;
    const PoreWater* water;
    const Vector<3>& g;
    OuterWater standing;

    explicit SeepageWeight(const Coefficients& c) : water(c.has<PoreWater>() ? &c.of<PoreWater>() : nullptr), g(c.g), standing(c) {}
    double weight(const auto& ij, const auto& i, const auto& j) const
    {
        return -1 / water->lattice.secondMoment * (sqr(i.V) + sqr(j.V)) * ij.dWdrOverR;
    }
    /// p_j - p_i less that of water at rest
    double headDifference(const auto& ij, const auto& i, const auto& j) const
    {
        return j.p_w - i.p_w + water->density * dot(in<dimensions(decltype(ij.x){})>(g), ij.x);
    }
    /// The depth d and alpha of a particle, by its sums of w_ij of neighbours at the surface and of w_ij x_ji.
    template<int dim> std::pair<double, double> surface(const auto& i, double besideSurface, Vector<dim> inwards) const
    {
        if (i.isSurface == loneGrain) return {0, water->lattice.weight};
        const double d = i.isSurface + besideSurface > 0 ? water->lattice.depth(i.m_1) : 0;
        return {d, d > 0 ? mag(inwards) / (i.V * d) : 0};
    }
    /// The factors k alpha and p_t of a particle at the depth d below a free surface, whose sum_j w_ij x_ji is `inwards`.
    template<int dim> std::pair<double, double> outflow(const auto& i, double k, double alpha, double d, Vector<dim> inwards) const
    {
        if (!(alpha > 0) || !water->surfaceDrains) return {0, 0};
        const auto toSurface = d > 0 ? -d / mag(inwards) * inwards : 0 * inwards;
        const double outside = standing.pressure(i.x + toSurface), target = outside - water->density * dot(in<dim>(g), toSurface);
        return {water->unsaturated && !(outside > 0) && !(i.p_w > target) ? 0 : k * alpha, target};
    }
};

/// The sum in full pores, without what passes surfaces; that; and the diagonal of the sum.
struct Seepage : SeepageWeight
{
    static constexpr auto name = "seepage";
    using Provides = Fields<PoreLaplacian, SurfaceDrainage, SurfaceOutflow, SurfaceTarget, SeepageDiagonal>;
    using Reads = Fields<Volume, PorePressure, SurfaceRow>;
    using ReadsOwn = Fields<KernelSlope, Position>;
    using SeepageWeight::SeepageWeight;
    template<int dim> struct Sums
    {
        double flow, weight, besideSurface;
        Vector<dim> inwards;
        static constexpr auto parts(auto& q, const auto& f) { return f(q.flow, q.weight, q.besideSurface, q.inwards); }
    };

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const double w = weight(ij, i, j);
        return Sums<dimensions(decltype(ij.x){})>{w * headDifference(ij, i, j), w, w * j.isSurface, -w * ij.x};
    }
    template<int dim> auto finish(const auto& i, const Sums<dim>& sum) const
    {
        const auto [d, alpha] = surface(i, sum.besideSurface, sum.inwards);
        const auto [out, target] = outflow(i, 1, alpha, d, sum.inwards);
        return Values<Provides, dim>{{sum.flow / i.V}, {alpha}, {out}, {target}, {sum.weight / i.V}};
    }
};

/// The same sum of the change that a solver tries.
struct SeepageOfChange : SeepageWeight
{
    static constexpr auto name = "seepageOfChange";
    using Provides = LaplacianOfChange;
    using Reads = Fields<Volume, PorePressureChange>;
    using SeepageWeight::SeepageWeight;

    auto operator()(const auto& ij, const auto& i, const auto& j) const { return weight(ij, i, j) * (j.dp_w - i.dp_w); }
    double finish(const auto& i, double sum) const { return sum / i.V; }
};

/// k_r
struct PermeabilityOfSaturation
{
    static constexpr auto name = "relativePermeability";
    using Provides = RelativePermeability;
    using ReadsOwn = Fields<PorePressure>;
    const PoreWater* water;
    const Vector<3>& g;

    explicit PermeabilityOfSaturation(const Coefficients& c) : water(c.has<PoreWater>() ? &c.of<PoreWater>() : nullptr), g(c.g) {}
    double operator()(const auto& i) const { return water->relativePermeability(i.p_w, mag(g)); }
};

/// Both sums where pores drain.
struct UnsaturatedSeepage : SeepageWeight
{
    static constexpr auto name = "unsaturatedSeepage";
    using Provides = Fields<PoreLaplacian, SurfaceDrainage, SurfaceOutflow, SurfaceTarget, SeepageDiagonal, GrainDiagonal>;
    using Reads = Fields<Volume, PorePressure, RelativePermeability, SurfaceRow>;
    using ReadsOwn = Fields<KernelSlope, Position>;
    using SeepageWeight::SeepageWeight;
    template<int dim> struct Sums
    {
        double flow, weight, ofGrains, besideSurface;
        Vector<dim> inwards;
        static constexpr auto parts(auto& q, const auto& f) { return f(q.flow, q.weight, q.ofGrains, q.besideSurface, q.inwards); }
    };

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const double w = weight(ij, i, j), k = 0.5 * (i.k_r + j.k_r);
        return Sums<dimensions(decltype(ij.x){})>{w * k * headDifference(ij, i, j), w * k,
                                                  0.5 * w * (PoreWater::actsAt(i.k_r) + PoreWater::actsAt(j.k_r)), w * j.isSurface,
                                                  -w * ij.x};
    }
    template<int dim> auto finish(const auto& i, const Sums<dim>& sum) const
    {
        const auto [d, alpha] = surface(i, sum.besideSurface, sum.inwards);
        const auto [out, target] = outflow(i, i.k_r, alpha, d, sum.inwards);
        return Values<Provides, dim>{{sum.flow / i.V}, {water->acts(i.p_w) * alpha}, {out},
                                     {target},         {sum.weight / i.V},           {sum.ofGrains / i.V}};
    }
};

struct UnsaturatedSeepageOfChange : SeepageWeight
{
    static constexpr auto name = "unsaturatedSeepageOfChange";
    using Provides = Fields<LaplacianOfChange, GrainsOfChange>;
    using Reads = Fields<Volume, PorePressureChange, RelativePermeability>;
    using SeepageWeight::SeepageWeight;
    template<int dim> struct Sums
    {
        double flow, ofGrains;
        static constexpr auto parts(auto& q, const auto& f) { return f(q.flow, q.ofGrains); }
    };

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const double w = 0.5 * weight(ij, i, j) * (j.dp_w - i.dp_w);
        return Sums<dimensions(decltype(ij.x){})>{w * (i.k_r + j.k_r), w * (PoreWater::actsAt(i.k_r) + PoreWater::actsAt(j.k_r))};
    }
    template<int dim> auto finish(const auto& i, const Sums<dim>& sum) const
    {
        return Values<Provides, dim>{{sum.flow / i.V}, {sum.ofGrains / i.V}};
    }
};

/// q = -kappa k_r (grad p - rho_w g), the gradient corrected as that of the velocity is.
struct DarcyVelocity : SeepageWeight
{
    static constexpr auto name = "seepageVelocity";
    using Provides = SeepageVelocity;
    using Reads = Fields<Volume, PorePressure>;
    using SeepageWeight::SeepageWeight;
    static constexpr double least = 0.3; ///< eigenvalue of B from which on the gradient is corrected
    template<int dim> struct Sums
    {
        SymmTensor<dim> B;
        Vector<dim> G;
        static constexpr auto parts(auto& q, const auto& f) { return f(q.B, q.G); }
    };

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return Sums<dimensions(decltype(ij.x){})>{-j.V * ij.dWdrOverR * outer(ij.x), j.V * headDifference(ij, i, j) * ij.gradW};
    }
    template<int dim> auto finish(const auto& i, const Sums<dim>& sum) const
    {
        const double share = leastEigenvalue(sum.B) > least ? 1 / determinant(sum.B) : 0;
        const auto gradient = share > 0 ? share * (adjugate(sum.B) * sum.G) : sum.G;
        return -water->mobility() * water->relativePermeability(i.p_w, mag(g)) * gradient;
    }
};

}
