/// The entry `sigma` of constant/phaseProperties, which packParticles reads as well as the solver.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph::entry
{

const PairValues sigma{"sigma", "surface tension", units::surfaceTension, nonNegative,
                       "surface tension of pairs of phases: of none, or of each, 0 included"};
const Scalar sigmaOfSurface{"sigma", units::surfaceTension, 0, nonNegative,
                            "surface tension of the liquid against a gas that is left out, by `gas none;` of system/sphSchemes"};

}
