/// Numbers of a suspension.
#pragma once
#include <optional>

namespace sph
{

/// Powder in a binder: the one phase of its scene.
struct Suspension
{
    std::optional<double> phi;          ///< volume fraction of powder at the start, where no field gives it [1]
    double phiMax = 1, phiCritical = 1; ///< phi_m of the densest packing, and from where the viscosity is capped [1]
    double exponent = 0;                ///< c of Krieger's viscosity [1]
    double Dc_a2 = 0, Deta_a2 = 0;      ///< D_c a^2 and D_eta a^2 of Phillips' fluxes [m^2]
    double shearShare = 0;              ///< alpha Delta_x^2/2 of the shear that a particle does not resolve [m^2]
};

}
