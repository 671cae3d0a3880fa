/// The laws of soil by name, and constant/soilProperties:
///
///     rho         1850;              // [kg/m^3] of the soil with its pores
///     law         wuBauer;
///     wuBauerCoeffs { c1 -69.4; c2 -673.1; c3 -655.9; c4 699.6; }
///     reduceStrength 1.4;            // c and tan phi over it
///     integrator  dormandPrince;     // or bogackiShampine
///     tolerance   1e-6;
///     turning     halves;            // or within
///     stressFree  floor;             // or detached
///     floorPressure 10;              // [Pa]
#pragma once
#include "soilLaws/DruckerPrager.hpp"
#include "soilLaws/IntergranularStrain.hpp"
#include "soilLaws/ModifiedCamClay.hpp"
#include "soilLaws/MohrCoulombSoftening.hpp"
#include "soilLaws/WuBauer.hpp"
#include "soilLaws/integrateStress.hpp"
#include <variant>

namespace sph
{

/// A law more is a word more here. One with an `Option` is that law with a sub-dictionary more in its coefficients.
using SoilLaw = std::variant<WuBauer, DruckerPrager, ElasticLaw, VonWolffersdorff, IntergranularStrain<VonWolffersdorff>, MohrCoulomb,
                             MohrCoulombSoftening, ModifiedCamClay>;

struct Soil
{
    double rho = 1; ///< [kg/m^3]
    SoilLaw law;
    StressIntegration integration;
};

inline const std::string soilProperties = "constant/soilProperties";
/// Entries that models which move soil read from that file.
inline constexpr const char *initialStressKeyword = "initialStress", *confiningPressureKeyword = "confiningPressure",
                            *poreWaterKeyword = "poreWater";

/// Whether a law's state is more than the stress: a void ratio, a softening strain.
bool hasVariables(const SoilLaw&);

/// The friction angles that act, in words, of laws that have some; else "".
std::string strengthInWords(const SoilLaw&);

/// Entries of the state variables at the start, of all laws that have some, without repetition.
EntryList variableEntries();

/// Mistakes are recorded with file and line. `turning`: what is taken where the file does not say.
Soil readSoil(const Dictionary&, const std::string& turning = "halves");
EntryList soilEntries();

}
