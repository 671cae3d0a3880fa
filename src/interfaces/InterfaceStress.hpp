/// Surface tension as an interface stress: Hu & Adams (2006), eqs. (11)-(13) of Barker et al. (2012) with erratum HL3 (the isotropic
/// part of eq. 12 carries |gradC|^2). For particle i of phase k, summed over every other phase l:
///
///   gradC = 1/V_i sum_(j in l) V_j^2 gradW_ij
///   S_i  += gamma_kl (|gradC| I/d - gradC gradC/|gradC|)
///
/// and, for each group g of walls with the same contact angle, the wall tension (NUMERICS): fluid within reach of the wall carries
///
///   S_i  += 2 gamma_sk |gradC_w| (I - n_w n_w),   gradC_w = 1/V_i sum_(ghosts j of g) V_j^2 gradW_ij,   n_w = gradC_w/|gradC_w|
///
/// with gamma_sl - gamma_sg = -gamma_lg cos(theta) shared by density (readPhases). A ghost has its parent's phase and its parent's stress mirrored,
/// so that fluid plus image carries no shear across the wall: Young's law is then the tangential momentum balance itself.
///
/// S [Pa] tension positive, gamma [N/m], gradC [1/m], V [m^3], d dimensions. Its divergence (StressDivergence) is the force.
/// Verified by test/unit/passes (plain loop), tutorials/verification/laplaceDrop and contactAngle.
#pragma once
#include "terms.hpp"

namespace sph
{

/// Sweeps over walls alone: the wall tension beside the curvature form.
struct WallTension
{
    static constexpr auto name = "wallTension";
    using Provides = Stress;
    using Reads = Fields<Volume>;
    using ReadsOwn = Fields<Phase>;
    const double* tension; ///< [N/m], groups x phases
    int phases;
    double least;          ///< |gradC| below which there is no wall [1/m]

    explicit WallTension(const Coefficients& c) : tension(c.wallTension.data()), phases(int(c.phases.size())), least(0.01/c.support) {}

    int sweeps(std::span<const long> ghosts) const { return int(ghosts.size()) - 1; }
    Sweep sweep(int s, std::span<const long> ghosts) const { return {s, ghosts[s], ghosts[s + 1]}; }

    auto operator()(const auto& ij, const auto&, const auto& j, Sweep s) const { return s.contains(ij.j)*sqr(j.V)*ij.gradW; }
    auto finish(const auto& i, const auto& sum, Sweep s) const
    {
        const auto g = 1/i.V*sum;
        const double size = mag(g), gamma = tension[s.number*phases + int(i.phase)];
        return size > least ? 2*gamma*(size*identity(g) - 1/size*outer(g)) : 0.0*identity(g);
    }
};

struct InterfaceStress
{
    static constexpr auto name = "interfaceStress";
    using Provides = Stress;
    using Reads = Fields<Volume, Phase>;
    const double* gamma; ///< [N/m], phases x phases
    int phases;
    double least;
    WallTension wall;

    explicit InterfaceStress(const Coefficients& c)
        : gamma(c.surfaceTension.data()), phases(int(c.phases.size())), least(0.01/c.support), wall(c)
    {}

    /// The other phase of sweep s, counted from the particle's own so that nobody sweeps over itself.
    double other(double phase, int s) const { return phase + s + 1 < phases ? phase + s + 1 : phase + s + 1 - phases; }

    int sweeps(std::span<const long> ghosts) const { return phases - 1 + wall.sweeps(ghosts); }
    Sweep sweep(int s, std::span<const long> ghosts) const
    {
        return s < phases - 1 ? Sweep{s, 0, 0} : Sweep{s, ghosts[s - phases + 1], ghosts[s - phases + 2]};
    }

    auto operator()(const auto& ij, const auto& i, const auto& j, Sweep s) const
    {
        const double ofOther = s.number < phases - 1 && j.phase == other(i.phase, s.number) ? 1.0 : 0.0;
        return (ofOther + s.contains(ij.j))*sqr(j.V)*ij.gradW;
    }
    auto finish(const auto& i, const auto& sum, Sweep s) const
    {
        if (s.number >= phases - 1) return wall.finish(i, sum, {s.number - phases + 1, s.from, s.to});
        const auto g = 1/i.V*sum;
        const double size = mag(g), gamma_kl = gamma[int(i.phase)*phases + int(other(i.phase, s.number))];
        return size > least ? gamma_kl*(size/dimensions(g)*identity(g) - 1/size*outer(g)) : 0.0*identity(g);
    }
};

}
