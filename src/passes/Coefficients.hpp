/// The numbers that terms are built from, read once from the dictionaries of a case. Plain data: terms copy what they need, and
/// point at the tables, which outlive them.
#pragma once
#include "Vector.hpp"
#include <optional>
#include <string>
#include <vector>

namespace sph
{

/// Powder in a binder: the one phase of its scene.
struct Suspension
{
    std::optional<double> phi;               ///< volume fraction of powder at the start, where no field gives it [1]
    double phiMax = 1, phiCritical = 1;      ///< phi_m of the densest packing, and from where the viscosity is capped [1]
    double exponent = 0;                     ///< c of Krieger's viscosity [1]
    double Dc_a2 = 0, Deta_a2 = 0;           ///< D_c a^2 and D_eta a^2 of Phillips' fluxes [m^2]
    double subParticleShear = 0;             ///< alpha [1]
};

struct Coefficients
{
    int dimension = 3;
    double spacing = 0;                      ///< mean particle spacing [m]
    double support = 0;                      ///< kernel support radius H [m]

    std::vector<std::string> phases;
    std::vector<double> restDensity;         ///< rho_0 of each phase [kg/m^3]
    std::vector<double> viscosity;           ///< mu [Pa s]
    std::vector<double> soundSpeed;          ///< c [m/s]
    std::vector<double> stiffness;           ///< B = rho_0 c^2/n [Pa]
    std::vector<double> exponent;            ///< n of the Tait equation; 1 is the linear state
    double backgroundPressure = 0;           ///< p_b [Pa], the same in all phases
    double leastPressure = -1e300;           ///< p_min [Pa], at which a fluid that is pulled parts

    std::vector<double> surfaceTension;      ///< gamma_kl [N/m], phases x phases
    std::vector<double> wallTension;         ///< gamma_sk [N/m], walls x phases; empty where no wall has a contact angle

    Vector<3> g;                             ///< [m/s^2]
    Vector<3> bodyForce;                     ///< [N/m^3]

    double densityScale = 1;                 ///< makes the mean of sigma V_0 exact
    double diffusion = 0;                    ///< delta of the density diffusion
    double transportVelocity = 0;            ///< C of the transport velocity: background pressure over rho c^2; 0: none
    double artificialViscosity = 0;          ///< alpha

    std::optional<Suspension> suspension;    ///< mu is then that of the binder
};

}
