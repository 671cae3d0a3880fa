/// Laplacian of the pore pressure, the sum that makes the flux of scalars (ScalarFlux.hpp), and what free surfaces add to it.
///
///   (lap p)_i = 1/V_i sum_j w_ij (p_j - p_i) [- alpha_i p_i],    w_ij = -(V_i^2 + V_j^2) (dW_ij/dr)/r_ij/N
///
/// N is the second moment of the slope on a lattice (KernelMoment.hpp), the same everywhere: with that of each particle, which falls to 0.6 at a surface, the outermost rows conducted too well, and rates of
/// consolidation were 2 % off at 32 particles across, of first order. Pairs exchange what they lose, and the matrix is symmetric with the weights V. Where the soil ends the sum lacks neighbours, and sees no flux: nothing passes.
/// Where p is 0 on a free surface it goes on linearly through it, at the depth d_i of the particle,
///
///   alpha_i = |sum_j w_ij x_ji|/(V_i d_i)
///
/// by which the sum is 0 for a p that is linear in the depth, however the particles lie: the neighbours that are missing have the first moment that the others lack. d from the first moment of the raw slope (LatticeSums),
/// and only beside particles of the surface: a lattice in disorder has first moments, too.
///
/// p [Pa], V [m^3], W [1/m^3], alpha [1/m^2]. Verified by test/unit/soil (linear and quadratic pressures below a surface; conservation).
#pragma once
#include "models/soil/PoreWater.hpp"
#include "models/soil/SoilFields.hpp"
#include "operators/GradientCorrection.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

// clang-format off
struct SurfaceRow        { static constexpr FieldInfo info{"surfaceRow", "1"};                        template<int dim, class Real = double> struct At { Real isSurface; }; };
struct KernelSlope       { static constexpr FieldInfo info{"kernelSlope", "1/m"};                     template<int dim, class Real = double> struct At { Real m_1; }; };
struct PoreLaplacian     { static constexpr FieldInfo info{"porePressureLaplacian", "Pa/m^2"};        template<int dim, class Real = double> struct At { Real lap; }; };
struct LaplacianOfChange { static constexpr FieldInfo info{"porePressureChangeLaplacian", "Pa/m^2"};  template<int dim, class Real = double> struct At { Real lap; }; };
struct SurfaceDrainage   { static constexpr FieldInfo info{"surfaceDrainage", "1/m^2"};               template<int dim, class Real = double> struct At { Real alpha; }; };
struct SeepageDiagonal   { static constexpr FieldInfo info{"seepageDiagonal", "1/m^2"};               template<int dim, class Real = double> struct At { Real diagonal; }; };
// clang-format on

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

    auto operator()(const auto& ij, const auto&, const auto& j) const
    {
        const double w = -j.V * ij.dWdrOverR;
        return SlopeMoments<dimensions(decltype(ij.x){})>{w * outer(ij.x), -w * ij.x};
    }
    auto finish(const auto&, const auto& sum) const
    {
        return Values<Provides, dimensions(decltype(sum.m_1){})>{{leastEigenvalue(sum.B) < mostAtSurface ? 1.0 : 0.0}, {mag(sum.m_1)}};
    }
};

/// w_ij of the raw slope.
struct SeepageWeight
{
    static constexpr bool ofRawGradient = true;
    LatticeSums lattice;

    explicit SeepageWeight(const Coefficients& c) : lattice(c.has<PoreWater>() ? c.of<PoreWater>().lattice : LatticeSums{}) {}
    double weight(const auto& ij, const auto& i, const auto& j) const
    {
        return -1 / lattice.secondMoment * (sqr(i.V) + sqr(j.V)) * ij.dWdrOverR;
    }
};

/// The sum, without alpha; alpha; and the diagonal of both.
struct Seepage : SeepageWeight
{
    static constexpr auto name = "seepage";
    using Provides = Fields<PoreLaplacian, SurfaceDrainage, SeepageDiagonal>;
    using Reads = Fields<Volume, PorePressure, SurfaceRow>;
    using ReadsOwn = Fields<KernelSlope>;
    using SeepageWeight::SeepageWeight;
    template<int dim> struct Sums
    {
        double flow, weight, besideSurface;
        Vector<dim> moment;
        static constexpr auto parts(auto& q, const auto& f) { return f(q.flow, q.weight, q.besideSurface, q.moment); }
    };

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const double w = weight(ij, i, j);
        return Sums<dimensions(decltype(ij.x){})>{w * (j.p_w - i.p_w), w, w * j.isSurface, -w * ij.x};
    }
    template<int dim> auto finish(const auto& i, const Sums<dim>& sum) const
    {
        const double d = i.isSurface + sum.besideSurface > 0 ? lattice.depth(i.m_1) : 0;
        return Values<Provides, dim>{{sum.flow / i.V}, {d > 0 ? mag(sum.moment) / (i.V * d) : 0}, {sum.weight / i.V}};
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

struct StressOfPorePressure
{
    static constexpr auto name = "poreStress";
    using Provides = PoreStress;
    using ReadsOwn = Fields<PorePressure, SoilStress>;
    auto operator()(const auto& i) const { return -i.p_w * identity(inPlane(i.sigma)); }
};

}
