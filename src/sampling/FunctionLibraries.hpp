/// Libraries of function objects, formulas and measures, loaded at run time as OpenFOAM does.
#pragma once
#include "dictionary/Parameter.hpp"

namespace sph
{

namespace entry
{
extern const ListOf<std::string> libs;
}

/// Loads what the entry `libs` of the dictionary names: of controlDict, or of one function object.
///
///     libs ("libcentreOfMass.so");        // `(centreOfMass)` is the same
///
/// A path ("<case>/libmine.so", "$HOME/lib/libmine.so") is relative to the case; a name alone is looked for in the folder of the case, in those of LD_LIBRARY_PATH, then where
/// the suite has its own. Errors are recorded at the entry: a library that is not there, does not load, was made for another version of the suite (told by
/// its interfaceTag before any of its code runs), brings no function objects, or one whose name is taken. A library that is loaded already is left as it is.
void loadLibraries(const Dictionary&);

/// A line for the log, "libcentreOfMass.so: centreOfMass", of each library that has been loaded.
std::vector<std::string> loadedLibraries();

}
