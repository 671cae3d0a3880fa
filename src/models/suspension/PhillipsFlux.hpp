/// Shear-induced migration of powder, Phillips et al. (1992), as eq. (3.8) of Kauzlaric et al. (2011) for particles of any mass, equal
/// ones in print, and phi at the density of rest (at its own, as in print: OfDensity.hpp):
///
///   m_i/rho_0 dphi_i/dt = dV_phi,i/dt = -sum_j V_i V_j w_ij { D_c a^2 (phi_i + phi_j) (phi_i gammaDot_i - phi_j gammaDot_j)
///                                                           + D_eta a^2 (B_i + B_j) (phi_i - phi_j) },    B = gammaDot phi^2 1/mu dmu/dphi
///
/// phi [1] volume fraction of powder, V_phi = phi m/rho_0 [m^3] the volume that powder takes up in a particle, V [m^3], w = -(dW/dr)/r,
/// gammaDot [1/s], a [m] the powder's size. Pairs exchange what they lose: sum V_phi is constant to round-off. No powder passes a wall:
/// pairs with ghosts are left out. The means are arithmetic on purpose: a harmonic one takes J_eta away where gammaDot = 0, and phi runs
/// through phi_m there. Erratum of Kauzlaric et al. (2011), eqs. (3.6)-(3.8): they hold for particles of one mass, set to 1; what is conserved is the sum of m_i phi_i.
/// Verified by test/unit/suspension (antisymmetry, conservation, a steady profile) and tutorials/powderMoulding.
#pragma once
#include "fields/fieldTags.hpp"
#include "models/suspension/SuspensionConstants.hpp"
#include "plan/Coefficients.hpp"

namespace sph
{

struct PhillipsFlux
{
    static constexpr auto name = "phillipsFlux";
    using Provides = PowderRate;
    using Reads = Fields<Volume, PowderFraction, ShearRate, RelativeViscositySlope, GhostWall>;
    using ReadsOwn = Fields<Mass>;
    double Dc_a2, Deta_a2, rho_0;

    explicit PhillipsFlux(const Coefficients& c)
        : Dc_a2(c.of<Suspension>().Dc_a2), Deta_a2(c.of<Suspension>().Deta_a2), rho_0(c.restDensity[0])
    {}
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        const double V = j.wall > 0 ? 0.0 : j.V;
        const double B = i.gammaDot * sqr(i.phi) * i.slope + j.gammaDot * sqr(j.phi) * j.slope;
        return i.V * V * ij.dWdrOverR *
               (Dc_a2 * (i.phi + j.phi) * (i.phi * i.gammaDot - j.phi * j.gammaDot) + Deta_a2 * B * (i.phi - j.phi));
    }
    double finish(const auto& i, double sum) const { return rho_0 / i.m * sum; }
};

}
