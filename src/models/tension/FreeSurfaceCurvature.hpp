/// Surface tension of a liquid alone, whose gas is left out: curvature from the liquid's side of its free surface, four sums.
///
/// With a density that is completed at the surface (models/gas/CompletedDensity.hpp) a uniform pressure p = -gamma kappa is balanced particle by particle, since pressure and tension are sums of the same
/// slopes. Verified by test/unit/gas (balls, discs and holes; the balance with the pressure;
/// the force along a surface) and tutorials/verification/laplaceDrop.
#pragma once
#include "fields/freeSurfaceTags.hpp"
#include "geometry/Shape.hpp"
#include "models/tension/NearestWall.hpp"
#include "models/tension/Tensions.hpp"
#include "models/tension/WallWetting.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

/// Normal of the free surface, into the liquid:
///
///   n_i = N_i/|N_i|,    N_i = sum_j V_j g_j W_ij,    g_j = sum_k gradW_jk
///
/// It means nothing deep inside, where t is 0 and nothing weighs
struct LiquidNormals
{
    using Provides = LiquidNormal;
    using Reads = Fields<Volume, SlopeSum>;
    static constexpr bool readsKernel = true;

    auto operator()(const auto& ij, const auto&, const auto& j) const { return j.V * ij.W * j.g; }
    auto finish(const auto&, const auto& sum) const { return 1 / (mag(sum) + 1e-300) * sum; }
};

/// P (y_j - y_i), P = I - n_i n_i, y = x - z n the foot of a particle on the surface [m].
inline auto alongSurface(const auto& ij, const auto& i, const auto& j)
{
    const auto y = i.z * i.n_l - j.z * j.n_l - ij.x;
    return y - dot(y, i.n_l) * i.n_l;
}

/// Two symmetric tensors of one loop.
template<int dim> struct TensorsOfFit
{
    SymmTensor<dim> a, b;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.a, q.b); }
};

/// Curvature of the surface that is nearest to i, at the feet y = x - z n of particles near it:
///
///   kappa_i = k/(1 + beta H^2 k^2/(d - 1)^2),    k = tr K,    K = argmin sum_j w_ij |P (n_j - n_i) - K P (y_j - y_i)|^2 = A B^-1,    P = I - n_i n_i
///   A = sum_j w_ij P (n_j - n_i) (y_j - y_i) P,    B = sum_j w_ij P (y_j - y_i) (y_j - y_i) P,    w_ij = V_j t_j W_ij
///
/// kappa [1/m] is the divergence of the normal into the liquid: -2/R of a drop in 3-D, -1/R in 2-D. z [m] depth, t [-] share of the surface (models/gas/FlatSurface.hpp), 1 at it and 0 inside. Of feet rather than
/// of particles, since those that the outermost see lie deeper, where surfaces parallel to that of a drop are more curved: kappa is then exact for spheres and cylinders however the particles lie, as far as normals and
/// depths are; beta (depthBias.hpp) is what depths are off near a curved surface, 1 % of kappa where a radius has 8 spacings and the support 3. Curvatures beyond one over the spacing are none that an arrangement of particles can show.
struct FreeSurfaceCurvature
{
    using Provides = RawCurvature;
    using Reads = Fields<Volume, LiquidNormal, SurfaceDepth, SurfaceShare>;
    static constexpr bool readsKernel = true;
    double most, bias; ///< [1/m], beta H^2/(d - 1)^2 [m^2]

    FreeSurfaceCurvature(const Coefficients& c, double beta) : most(1 / c.spacing), bias(beta * sqr(c.support / (c.dimension - 1))) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        constexpr int dim = dimensions(decltype(ij.x){});
        const double w = j.V * j.t * ij.W;
        const auto along = alongSurface(ij, i, j), n = j.n_l - i.n_l, turn = n - dot(n, i.n_l) * i.n_l;
        return TensorsOfFit<dim>{w * symm(turn, along), w * outer(along)};
    }
    /// B^-1, 0 where B has none.
    static auto inverse(const auto& i, const auto& sum)
    {
        const auto B = sum.b + trace(sum.b) * outer(i.n_l);
        const double det = determinant(B), tiny = 1e-300;
        return (det > tiny ? 1 / det : 0.0) * adjugate(B);
    }
    double bounded(double k) const { return std::fmax(-most, std::fmin(most, k / (1 + bias * k * k))); }
    auto finish(const auto& i, const auto& sum) const { return bounded(doubleDot(sum.a, inverse(i, sum))); }
};

/// The same beside walls, whose mirror images make n . n_w an odd function of the height above the wall: in the row next to it the curvature across the wall is that of the strip from the wall to the row's far side,
///
///   kappa_i += |e|^2 w [(n . n_w + dx K_e/2)/(h + dx/2) - K_e],    e = P n_w,    K_e = e K e/|e|^2,    h = d - z n . n_w
///
/// n_w normal of the nearest wall that has lines of contact (NearestWall.hpp), d [m] distance from it, h [m] height of the foot; w is 1 up to h = dx and 0 from 3/2 dx on. A fit over one support does not see how a surface turns between its wall and the foot of the
/// lowest row; what it gives then adds up to more than the surface turns, and drove drops along their planes (README.md of models/gas). |e| is the sine of the angle between surface and wall: a film has none.
struct FreeSurfaceCurvatureAtWalls : FreeSurfaceCurvature
{
    using ReadsOwn = Fields<NearestWallNormal, WallDistance>;
    double spacing, closest; ///< [m]

    /// `d_0`: distance at which walls hold particles [m], the least that h counts as.
    FreeSurfaceCurvatureAtWalls(const Coefficients& c, double beta, double d_0)
        : FreeSurfaceCurvature(c, beta), spacing(c.spacing), closest(d_0)
    {}
    auto finish(const auto& i, const auto& sum) const
    {
        const auto inverse_B = inverse(i, sum);
        double k = doubleDot(sum.a, inverse_B);
        const double towards = dot(i.n_w, i.n_l), h = i.d - i.z * towards, q = 2 * (h / spacing - 1);
        const auto e = i.n_w - towards * i.n_l;
        const double sine2 = dot(e, e), least = 0.01;
        if (sine2 > least && q < 1)
        {
            const double row = 1 - smoothStep(q), K_e = dot(e, sum.a * (inverse_B * e)) / sine2;
            k += sine2 * row * ((towards + 0.5 * spacing * K_e) / (std::fmax(h, closest) + 0.5 * spacing) - K_e);
        }
        return bounded(k);
    }
};

/// The curvature smoothed over what lies at the surface:
///
///   kappa_i = sum_j V_j t_j kappa_j W_ij/q_i,    q_i = sum_j V_j t_j W_ij
///
/// q is 0.2 to 0.3 at a surface and 1e-4 inside, where kappa fades out from 0.03 to 0.01.
struct FreeSurfaceSmoothing
{
    using Provides = Curvature;
    using Reads = Fields<Volume, SurfaceShare, RawCurvature>;
    static constexpr bool readsKernel = true;
    static constexpr double none = 0.01, whole = 0.03;

    auto operator()(const auto& ij, const auto&, const auto& j) const { return j.V * j.t * ij.W * Vector<2>{j.rawKappa, 1.0}; }
    /// 1 at a surface, 0 inside.
    static double presence(double q) { return std::fmax(0.0, std::fmin(1.0, (q - none) / (whole - none))); }
    auto finish(const auto&, Vector<2> sum) const { return sum.y > none ? presence(sum.y) * sum.x / sum.y : 0.0; }
};

/// The same with what walls add to it (WallWetting.hpp).
struct WettedSurfaceSmoothing : FreeSurfaceSmoothing
{
    using ReadsOwn = Fields<WettingCurvature>;
    auto finish(const auto& i, Vector<2> sum) const { return FreeSurfaceSmoothing::finish(i, sum) + presence(sum.y) * i.k_w; }
};

/// A force at the surface, and the slope of the curvature along it, of one loop.
template<int dim> struct ForceAndSlope
{
    Vector<dim> force, b;
    SymmTensor<dim> B;
    static constexpr auto parts(auto& q, const auto& f) { return f(q.force, q.b, q.B); }
};

/// Force of surface tension at a free surface:
///
///   dv_i/dt = -1/m_i [ (gamma kappa_i - min(p_i, 0) e_i) sum_j (V_i^2 + V_j^2) gradW_ij - gamma V_i 2 L_i grad_s kappa_i ]
///
/// grad_s kappa = B^-1 sum_j w_ij (kappa_j - kappa_i) P (y_j - y_i) with P, B, w as in FreeSurfaceCurvature; L = 1 - s what a plane surface lacks, 0.5 at it and 0 inside; e_i the share of the interior (InteriorShare).
///
/// The first sum is 0 inside, and that of a pressure gamma |kappa| beyond the surface at it. It acts over a depth, f = -gamma kappa phi(z) n with phi = 2 int W dA and int phi dz = 1, where surface tension is a pressure
/// at the surface: f = grad(gamma kappa 2 L) - gamma 2 L grad_s kappa, a pressure of -gamma kappa at the surface and a force along it. The second term takes that away: with the first alone a drop of n lobes has
/// n <z>/R less of the stiffness that it should have, <z> = 0.19 H, and its period was 7.5 and 3.7 % too long at 8 and 16 spacings a radius.
///
/// The slope is 0 where det B is below 1e-3 (tr B)^d, and 1/dx^2 at most: a particle in a corner that sees hardly more than its own images has none, and was thrown at 8e4 m/s.
///
/// Below the pressure of the gas, p < 0, that of Hu & Adams pulls each particle to where its neighbours are denser: lines of particles and voids between them form, and each void is taken for a surface (tensile instability: Swegle, Hicks &
/// Attaway 1995). Inside, e > 0, the term with p makes of it -sum_j (p_j - p_i) V_j^2 gradW_ij, which is 0 where p is uniform however the particles lie (the control of Sun et al. (2018), as in TensileControlledPressure of models/pressure); at the surface p keeps the
/// form that balances tension. A column between plates that it wets at 60 degrees keeps 0.1 J of motion without it, and 1e-6 J with it.
///
/// With (kappa_i + kappa_j)/2 pairs would conserve momentum, but the force were that of a pressure which ends at the surface, and would move nothing; FreeBodies.hpp
/// balances what is left over.
struct FreeSurfaceForce
{
    using Provides = TensionAcceleration;
    using Reads = Fields<Volume, Curvature, LiquidNormal, SurfaceDepth, SurfaceShare>;
    using ReadsOwn = Fields<Mass, SurfaceLack, Pressure>;
    static constexpr bool readsKernel = true;
    static constexpr double leastDeterminant = 1e-3; ///< of B over the power of its trace: a particle in a corner sees its own images alone
    double gamma, most;                              ///< [N/m]; of the slope [1/m^2]

    explicit FreeSurfaceForce(const Coefficients& c) : gamma(tensionsOf(c).largest()), most(1 / sqr(c.spacing)) {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        constexpr int dim = dimensions(decltype(ij.x){});
        const double w = j.V * j.t * ij.W;
        const auto along = alongSurface(ij, i, j);
        return ForceAndSlope<dim>{(sqr(i.V) + sqr(j.V)) * ij.gradW, w * (j.kappa - i.kappa) * along, w * outer(along)};
    }
    auto finish(const auto& i, const auto& sum) const
    {
        constexpr int dim = dimensions(decltype(sum.force){});
        const auto B = sum.B + trace(sum.B) * outer(i.n_l);
        const double det = determinant(B), tiny = 1e-300;
        const auto fitted = (det > leastDeterminant * std::pow(trace(B), dim) + tiny ? 1 / det : 0.0) * (adjugate(B) * sum.b);
        const auto slope = std::fmin(1.0, most / (mag(fitted) + tiny)) * fitted;
        const double suction = std::fmin(i.p, 0.0) * InteriorShare::of(i.t);
        return -1 / i.m * ((gamma * i.kappa - suction) * sum.force - 2 * gamma * i.lack * i.V * slope);
    }
};

/// dv_i/dt += a_t,i
struct AddTension
{
    using Adds = Acceleration;
    using ReadsOwn = Fields<TensionAcceleration>;
    auto operator()(const auto& i) const { return i.a_t; }
};

/// Ghosts of walls within the support; reads the numbers of particles, so that copies of other ranks' have them, by which a body is followed through periodic faces (FreeBodies.hpp).
struct CountGhosts
{
    using Provides = GhostsSeen;
    using Reads = Fields<GhostWall, ParticleNumber>;
    auto operator()(const auto&, const auto&, const auto& j) const { return j.wall > 0 ? 1.0 : 0.0; }
};

}
