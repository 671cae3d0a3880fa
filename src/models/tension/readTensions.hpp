/// Reads gamma_kl of each pair of phases from `sigma ( (water air) 0.072 );` of constant/phaseProperties.
#pragma once
#include "dictionary/Dictionary.hpp"
#include "models/tension/Tensions.hpp"

namespace sph
{

/// Tensions of the phases of c [N/m], phases x phases: where one pair has a value all must, for a pair left out by mistake would mix. What is wrong
/// is recorded with the dictionary's diagnostics.
std::vector<double> readTensions(const Dictionary& phaseProperties, const Coefficients& c);

/// Tension of the free surface of the one phase, from `water { sigma 0.072; }`, with a gas that is left out.
std::vector<double> readSurfaceTension(const Dictionary& phaseProperties, const Coefficients& c);

}
