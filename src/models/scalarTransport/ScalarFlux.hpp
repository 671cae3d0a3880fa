/// A dilute scalar c, amount per mass, that rides on the particles and diffuses between them, d(rho c)/dt = div(rho D grad c):
///
///   m_i dc_i/dt = sum_j k_ij (V_i^2 + V_j^2) (dW_ij/dr)/r_ij (c_i - c_j),    k_ij = 2 k_i k_j/(k_i + k_j),    k = rho_0 D
///
/// c [1] (or [K] ...), m [kg], D [m^2/s], rho_0 [kg/m^3] of the phase at rest, V = 1/sigma [m^3]. It is the sum that makes the force of viscosity,
/// with k for mu: Hu & Adams (2006), eq. (10) of Barker et al. (2012). The harmonic mean makes the flux continuous between phases, where c is
/// continuous too. Pairs exchange what they lose: sum m_i c_i is constant to round-off. With a normalised gradient (KernelMoment.hpp) of order 2.
/// Verified by test/unit/scalarTransport (plain loop, conservation, two layers, walls) and tutorials/verification/diffusion.
///
/// At walls the ghost of j, behind wall w, has
///
///   c_g = 2 c_w - c_j      where w has a value c_w: of second order at a plane wall
///   c_g = c_j              where nothing passes w, and all walls are planes, parallel or at right angles: then ghosts exchange pairwise, too
///   no part in the sum     where nothing passes w otherwise: volume factors of curved walls are not the same from both sides. Along such a wall
///                          the outermost particles lack neighbours to diffuse to: of first order. A wave along a channel as wide as half its
///                          length is 1.8, 0.88 and 0.43 % off at 16, 32 and 64 spacings that way; 0.36, 0.090 and 0.023 % with c_g = c_j
#pragma once
#include "base/Vector.hpp"
#include "models/scalarTransport/TransportedScalar.hpp"

namespace sph
{

/// One k everywhere: no field, no column.
struct UniformDiffusivity
{
    template<class... Other> using Reads = Fields<Volume, Other...>;
    double k; ///< rho_0 D [kg/(m s)]
    double mean(const auto&, const auto&) const { return k; }
};

/// The harmonic means of all pairs of phases.
struct DiffusivityOfPhases
{
    template<class... Other> using Reads = Fields<Volume, Other..., Phase>;
    const double* k; ///< phases x phases
    int phases;
    double mean(const auto& i, const auto& j) const { return k[int(i.phase) * phases + int(j.phase)]; }
};

struct NoWalls
{
    template<class Diffusivity> using Reads = typename Diffusivity::template Reads<ScalarValue>;
    double difference(const auto& i, const auto& j) const { return i.c - j.c; }
};

/// share (c_i - (offset + sign c_j)), by the place of j: 0 in the fluid, 1 + w in a ghost.
struct ScalarAtWalls
{
    template<class Diffusivity> using Reads = typename Diffusivity::template Reads<ScalarValue, GhostWall>;
    const double *share, *sign, *offset;
    double difference(const auto& i, const auto& j) const
    {
        const int w = int(j.wall);
        return share[w] * (i.c - (offset[w] + sign[w] * j.c));
    }
};

template<class Diffusivity, class Walls> struct ScalarFlux
{
    using Adds = ScalarRate;
    using Reads = typename Walls::template Reads<Diffusivity>;
    using ReadsOwn = Fields<Mass>;
    Diffusivity diffusivity;
    Walls walls;

    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return diffusivity.mean(i, j) * (sqr(i.V) + sqr(j.V)) * ij.dWdrOverR * walls.difference(i, j);
    }
    double finish(const auto& i, double sum) const { return sum / i.m; }
};

}
