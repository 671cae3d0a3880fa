/// Liquid alone: density completed at its free surface, beyond which a gas that is left out has a constant pressure, 0.
///
///   g_i = sum_j gradW_ij,    t_i = min(1, (|g_i| V_0/g_m)^2)
///   V_i = V_0/S_i,    S_i = max(S_min, a V_0 sum_j W_ij + c_1 t_i + c_2 t_i^2 + c_3 t_i^3)       j = i included
///   N_i = N_0
///
/// The completion is what a plane surface lacks (FlatSurface.hpp). With V of the completed density the state equation gives p = 0 at a surface of liquid at rest, and the pressure
/// of Hu & Adams, which finds no neighbours beyond, is there a free surface at constant pressure: p is flat up to the outermost particle. The bulk carries no reference pressure; one of the order of
/// gamma/spacing would make its lattice stiff against shear (README.md).
///
/// S_min = 0.9 bounds the tension of what has hardly a neighbour, as spray has, whose density no completion by t makes whole.
///
/// a [-] scale of the number density (DensityScale.hpp); g [1/m^(d + 1)], V [m^d], V_0 that at rest, N the gradient's normalisation (operators/KernelMoment.hpp), z [m] depth below the surface, with t. Not the gradient of an energy: the pressure's pair force is symmetric, so
/// that momentum is conserved, but S changes with g too. Verified by test/unit/gas.
#pragma once
#include "fields/freeSurfaceTags.hpp"
#include "models/gas/FlatSurface.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

/// sum_j W_ij and g_i, of one loop.
template<int dim> struct KernelAndSlope
{
    double W;
    Vector<dim> g;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.W, q.g); }
};

/// S_min
inline constexpr double leastShareOfDensity = 0.9;

struct CompletedVolume
{
    using Provides = Fields<Volume, SlopeSum, SurfaceShare, SurfaceLack, SurfaceDepth>;
    static constexpr bool readsKernel = true, ofRawGradient = true;
    FlatSurface surface;
    double a, V_0;

    explicit CompletedVolume(const Coefficients& c) : surface(c.of<FlatSurface>()), a(c.densityScale), V_0(std::pow(c.spacing, c.dimension))
    {}
    auto operator()(const auto& ij, const auto&, const auto&) const { return KernelAndSlope<dimensions(decltype(ij.x){})>{ij.W, ij.gradW}; }
    auto finish(const auto&, const auto& sum) const
    {
        constexpr int dim = dimensions(decltype(sum.g){});
        const double t = surface.share(mag(sum.g)), lack = surface.lackOfDensity(t);
        return Values<Provides, dim>{
            {V_0 / std::fmax(leastShareOfDensity, a * V_0 * sum.W + lack)}, {sum.g}, {t}, {lack}, {surface.depthAt(t)}};
    }
};

/// N_0 of a lattice, everywhere: pressure and tension are then N_0^-1 of the sums of raw slopes, and a uniform pressure has no force where g is 0. With M_i V_i, completed by t at the surface to within 0.05,
/// slopes of pairs from one to three rows below the surface did not cancel where kappa has faded out: the pressure inside a disc was 1.3 % above that at its surface however fine the resolution. Disordered particles inside have an N of about 0.99 N_0: viscosity and pressure gradients are
/// that much too small.
struct UniformNormalisation
{
    using Provides = GradientScale;
    using ReadsOwn = Fields<Volume>;
    double N_0;

    explicit UniformNormalisation(const Coefficients& c) : N_0(c.of<FlatSurface>().normalisation) {}
    auto operator()(const auto&) const { return N_0; }
};

}
