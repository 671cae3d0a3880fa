/// The entry of system/sphSchemes that asks for labels of particles, which decomposeParticles reads as well as the solver.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{
inline constexpr const char *origId = "origId", *origProcId = "origProcId";
}

namespace sph::entry
{

const Choices shown{"shown",
                    "fields",
                    {{origId,
                      "a number that each particle keeps for life, from 0 in the order of the first time folder, and no other ever has"},
                     {origProcId, "the rank that it came into being on"}},
                    std::vector<std::string>{},
                    "labels of particles in time folders, by OpenFOAM's names"};

}
