/// system/decomposeParDict: how ranks share the particles. OpenFOAM's name and words; the file may be missing.
#pragma once
#include "Case.hpp"
#include "EntryList.hpp"
#include "Settings.hpp"

namespace sph
{

inline constexpr const char* decompositionDictionary = "system/decomposeParDict";

///     numberOfSubdomains 4;
///     method rcb;
///     maxImbalance 1.1;
///
/// An error where the run has been started with another number of ranks. One process alone reads nothing of it.
void readDecomposition(const Case&, Settings&);
EntryList decompositionEntries();

}
