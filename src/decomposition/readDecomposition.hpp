/// Settings of system/decomposeParDict: how ranks and folders share particles. OpenFOAM's name and words.
#pragma once
#include "case/Case.hpp"
#include "decomposition/divide.hpp"
#include "dictionary/EntryList.hpp"
#include <optional>

namespace sph
{

inline constexpr const char* decompositionDictionary = "system/decomposeParDict";

struct Decomposition
{
    int parts = 1;
    Division method = Division::rcb; ///< of decomposeParticles
    double maxImbalance = 1.02;      ///< of ranks: processor time of the busiest over the mean, lately
};

///     numberOfSubdomains 4;
///     method rcb;
///     maxImbalance 1.02;
///
/// For a run of so many ranks the file may be missing, and another number of subdomains is an error; without `ranks` both must be there.
Decomposition readDecomposition(const Case&, std::optional<int> ranks = {});
EntryList decompositionEntries();

}
