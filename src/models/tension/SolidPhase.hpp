/// Contact angle as Barker et al. (2012) have it: the solid is a phase of its own, and eqs. (11)-(13) (InterfaceStress.hpp) hold for it as
/// for any other. Ghosts behind wall w are of phase s_w, and not of the phase of the particles that they mirror.
///
///   gradC^(kl) = 1/V_i sum_(j in l) V_j^2 gradW_ij
///   S_i = sum_(l != k) gamma_kl (|gradC| I/d - gradC gradC/|gradC|),    l over fluid phases and solids
///
/// S [Pa] tension positive, gamma [N/m], gradC [1/m], V [m^3], d dimensions. gamma_ks is the wall's tension, by Young's law,
/// gamma_sg - gamma_sl = gamma_lg cos(theta). Young leaves a common offset open; it is taken so that rho_g gamma_sl + rho_l gamma_sg = 0
/// (setContactAngles), at equal densities -+ gamma cos(theta)/2: it cancels in the balance at the contact line.
///
/// The paper does not say which stress a ghost has. Here it is that of eq. (13) for a particle of the solid (StressOfSolid). With the fluid's
/// own stress mirrored there is no shear across the wall and the fluid has but half of gamma_ks, the half on its side: cos(theta)/2, 75.5
/// degrees in the place of 60 (measured: 74.2).
///
/// Measured (tutorials/verification/contactAngle with `contactAngle paper;`): 65.0, 88.1 and 109.9 for 60, 90 and 120 degrees from the half
/// disc, 62.4 and 112.8 for 60 and 120 from the cap. Too small at large angles, as the solid does not move with the stress it is given;
/// WallTension, within 3 degrees, has no such loss. Walls with different names are different solids, each with its own gradient.
/// Conserves linear momentum only without walls, where it is InterfaceStress.
#pragma once
#include "models/tension/InterfaceStress.hpp"
#include "models/tension/Tensions.hpp"

namespace sph
{

/// S of the fluid: one sweep for each other fluid phase, then one for each wall. In the place of InterfaceStress.
///
/// Verified by test/unit/tension (plain loop).
struct SolidPhaseStress
{
    static constexpr auto name = "solidPhaseStress";
    using Adds = Stress;
    using Reads = Fields<Volume, Phase, GhostWall>;
    const double *gamma, *wallGamma; ///< [N/m], phases x phases; walls x phases
    int phases, walls;
    double least; ///< |gradC| below which there is no interface [1/m]

    explicit SolidPhaseStress(const Coefficients& c)
        : gamma(tensionsOf(c).between.data()),
          wallGamma(tensionsOf(c).ofWalls.data()),
          phases(int(c.phases.size())),
          walls(int(tensionsOf(c).ofWalls.size()) / phases),
          least(0.01 / c.support)
    {}

    int sweeps() const { return phases - 1 + walls; }
    /// Fluid phases count from 0, the solid behind wall w is phases + w. No particle sweeps over its own phase.
    double other(double phase, Sweep s) const
    {
        const double next = phase + s.number + 1;
        return s.number >= phases - 1 ? s.number + 1 : next < phases ? next : next - phases;
    }

    auto operator()(const auto& ij, const auto& i, const auto& j, Sweep s) const
    {
        const double phase_j = j.wall > 0 ? phases + j.wall - 1 : double(j.phase);
        return (phase_j == other(i.phase, s) ? 1.0 : 0.0) * sqr(j.V) * ij.gradW;
    }
    auto finish(const auto& i, const auto& sum, Sweep s) const
    {
        const int k = int(i.phase), l = int(other(i.phase, s));
        return tensionAcross(1 / i.V * sum, l < phases ? gamma[k * phases + l] : wallGamma[(l - phases) * phases + k], least);
    }
};

/// S of the solid, in the mirror: what the ghost of i sees of fluid phase k is the mirror image of what i sees of the ghosts of phase k.
///
///   S_s,i = sum_(walls, k) gamma_sk (|g| I/d - g g/|g|),    g = 1/V_i sum_(j ghost of that wall, its parent in k) V_j^2 gradW_ij
///
/// So ghosts need no neighbour lists: they mirror S_s of their parents where they would mirror S (`ofGhosts` of the tag). Exact behind
/// a plane; behind curved walls up to d/R; where two walls are nearer to each other than twice the support, ghosts of one have the
/// other's tension as well. It reads what SolidPhaseStress reads, and is therefore there before images ask for S.
///
/// Verified by test/unit/tension (plain loop, and ghosts' own sums behind plane walls).
struct StressOfSolid
{
    static constexpr auto name = "stressOfSolid";
    using Provides = SolidStress;
    using Reads = Fields<Volume, Phase, GhostWall>;
    const double* wallGamma; ///< [N/m], walls x phases
    int phases, walls;
    double least; ///< [1/m]

    explicit StressOfSolid(const Coefficients& c)
        : wallGamma(tensionsOf(c).ofWalls.data()),
          phases(int(c.phases.size())),
          walls(int(tensionsOf(c).ofWalls.size()) / phases),
          least(0.01 / c.support)
    {}

    int sweeps() const { return walls * phases; }
    auto operator()(const auto& ij, const auto&, const auto& j, Sweep s) const
    {
        const bool counts = (j.wall - 1) * phases + j.phase == s.number && j.wall > 0;
        return (counts ? 1.0 : 0.0) * sqr(j.V) * ij.gradW;
    }
    auto finish(const auto& i, const auto& sum, Sweep s) const { return tensionAcross(1 / i.V * sum, wallGamma[s.number], least); }
};

}
