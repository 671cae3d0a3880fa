/// The volume fraction of powder, phi, of the volume V_phi [m^3] that powder takes up in a particle. The scene keeps and conserves phi_0 = rho_0 V_phi/m,
/// the fraction at the density of rest, under the name of phi; what reads phi comes in two kinds.
#pragma once
#include "Coefficients.hpp"
#include "fieldTags.hpp"

namespace sph
{

/// phi = rho_0 V_phi/m: the fluid is incompressible, and what its density wavers by is no powder.
struct FractionAtRest
{
    template<class... Other> using Reads = Fields<PowderFraction, Other...>;
    explicit FractionAtRest(const Coefficients&) {}
    double operator()(const auto& i) const { return i.phi; }
};

/// phi = rho V_phi/m, as Kauzlaric et al. (2011) have it in eqs. (3.6) and (3.8), with m = 1. Particles at rest do not tell the two apart; where they move,
/// disordered and strained by 20 (`moving` of tutorials/powderMoulding/channel9, phi_0 against the steady profile), 9, 19, 39 across have 0.37, 0.21, 0.24 %
/// of error, and 0.44, 0.29, 0.25 % with the other.
struct FractionOfDensity
{
    template<class... Other> using Reads = Fields<PowderFraction, Density, Other...>;
    double perDensity;
    explicit FractionOfDensity(const Coefficients& c) : perDensity(1 / c.restDensity[0]) {}
    double operator()(const auto& i) const { return perDensity * i.rho * i.phi; }
};

}
