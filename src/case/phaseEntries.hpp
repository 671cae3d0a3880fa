/// Entries of constant/phaseProperties and constant/g that packParticles reads as well as the solver.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{
/// Word of `stress` of a phase without a state equation.
inline constexpr const char* byLaw = "constitutiveLaw";
}

namespace sph::entry
{

const ListOf<std::string> phases{"phases", required, "names of the phases; each has a dictionary"};
const FreeName phaseName{"<phase>", "dictionary", "a phase of that name"};
const Scalar rho{"rho", units::density, required, positive, "density at rest"};
const Choice stress{"stress",
                    {{"stateEquation", "-p I, and the viscous stress"}, {byLaw, "that of constant/soilProperties"}},
                    "stateEquation",
                    "what the stress of the phase is"};
const VectorParameter gravity{"value", units::mPerS2, required, "gravity"};
const Text shaking{
    "shaking", notGiven,
    "what is added to value [m/s^2], a vector(...) of the time $t [s]: less the acceleration of a vessel that is shaken, as seen by the vessel"};

}
