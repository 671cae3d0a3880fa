/// The volume fraction of powder as Kauzlaric et al. (2011) have it in eqs. (3.6) and (3.8), there with m = 1:
///
///   phi = rho V_phi/m
///
/// V_phi [m^3] volume that powder takes up in a particle, rho [kg/m^3], m [kg]. The scene keeps, conserves and writes rho_0 V_phi/m under the name of phi,
/// the fraction at the density of rest, which Krieger.hpp and PhillipsFlux.hpp take as it is: the fluid is incompressible, and what its density wavers by
/// is no powder. Particles at rest do not tell the two apart; where they move, disordered and strained by 20 (`moving` of
/// tutorials/powderMoulding/channel9), 9, 19, 39 across have 0.37, 0.21, 0.24 % of error in phi by these, and 0.44, 0.29, 0.25 % by the others.
/// Verified by test/unit/suspension (plain loop, conservation, hand values).
#pragma once
#include "models/suspension/Krieger.hpp"
#include "models/suspension/PhillipsFlux.hpp"

namespace sph
{

/// A particle's values with the fraction at its density.
auto atDensity(auto i, double rho_0)
{
    i.phi *= i.rho / rho_0;
    return i;
}

/// A law of phi.
template<class Law> struct LawOfDensity : Law
{
    using ReadsOwn = Fields<PowderFraction, Density>;
    double rho_0;

    explicit LawOfDensity(const Coefficients& k) : Law(k), rho_0(k.restDensity[0]) {}
    auto operator()(const auto& i) const { return Law::operator()(atDensity(i, rho_0)); }
};
struct KriegerOfDensity : LawOfDensity<Krieger>
{
    static constexpr auto name = "kriegerOfDensity";
    using LawOfDensity::LawOfDensity;
};
struct KriegerSlopeOfDensity : LawOfDensity<KriegerSlope>
{
    static constexpr auto name = "kriegerSlopeOfDensity";
    using LawOfDensity::LawOfDensity;
};

struct PhillipsFluxOfDensity : PhillipsFlux
{
    static constexpr auto name = "phillipsFluxOfDensity";
    using Reads = Fields<Volume, PowderFraction, Density, ShearRate, RelativeViscositySlope, GhostWall>;
    using PhillipsFlux::PhillipsFlux;
    auto operator()(const auto& ij, const auto& i, const auto& j) const
    {
        return PhillipsFlux::operator()(ij, atDensity(i, rho_0), atDensity(j, rho_0));
    }
};

}
