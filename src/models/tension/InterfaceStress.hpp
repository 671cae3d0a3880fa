/// Surface tension as an interface stress: Hu & Adams (2006), eqs. (11)-(13) of Barker et al. (2012). For particle i of phase k, summed over every other phase l:
///
///   gradC = 1/V_i sum_(j in l) V_j^2 gradW_ij
///   S_i  += gamma_kl (|gradC| I/d - gradC gradC/|gradC|)
///
/// S [Pa] tension positive, gamma [N/m], gradC [1/m], V [m^3], d dimensions. Its divergence (StressDivergence) is the force.
/// Verified by test/unit/tension (plain loop), tutorials/verification/laplaceDrop and contactAngle. Erratum of Barker et al. (2012), eq. (12): the isotropic part
/// carries |gradC|^2, as in Hu & Adams; with |gradC| the two parts have different units. Erratum of Barker et al. (2012), eq. (13): the sum is over l != k.
#pragma once
#include "models/tension/Tensions.hpp"
#include "plan/terms.hpp"

namespace sph
{

/// gamma (|g| I/d - g g/|g|), nothing where |g| is below `least`.
inline auto tensionAcross(const auto& g, double gamma, double least)
{
    const double size = mag(g);
    return size > least ? gamma * (size / dimensions(g) * identity(g) - 1 / size * outer(g)) : 0.0 * identity(g);
}

struct InterfaceStress
{
    static constexpr auto name = "interfaceStress";
    using Adds = Stress;
    using Reads = Fields<Volume, Phase>;
    const double* gamma; ///< [N/m], phases x phases
    int phases;
    double least; ///< |gradC| below which there is no interface [1/m]

    explicit InterfaceStress(const Coefficients& c)
        : gamma(tensionsOf(c).between.data()), phases(int(c.phases.size())), least(0.01 / c.support)
    {}

    /// The other phase of a sweep, counted from the particle's own so that nobody sweeps over itself.
    double other(double phase, Sweep s) const
    {
        const double next = phase + s.number + 1;
        return next < phases ? next : next - phases;
    }
    int sweeps() const { return phases - 1; }

    auto operator()(const auto& ij, const auto& i, const auto& j, Sweep s) const
    {
        return (j.phase == other(i.phase, s) ? 1.0 : 0.0) * sqr(j.V) * ij.gradW;
    }
    auto finish(const auto& i, const auto& sum, Sweep s) const
    {
        return tensionAcross(1 / i.V * sum, gamma[int(i.phase) * phases + int(other(i.phase, s))], least);
    }
};

}
