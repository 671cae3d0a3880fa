/// A variant of a case as a case of its own.
///
///     fine    { "system/sphSchemes" { resolution { spacing 0.025; } } }           // of system/variantsDict
///     jitter  { "system/packParticlesDict" { jitter 0.1; } }
///
/// Variant `fine` is the case with that entry. `jitter-fine`, where the dictionary has none of that name, is the case with both, the latter on top of the former.
/// Files of a folder variants/fine replace those of the case before any entry is changed.
#pragma once
#include "dictionary/EntryList.hpp"
#include <filesystem>

namespace sph
{

inline const std::string variantsDictionary = "system/variantsDict";

EntryList variantEntries();

/// Makes or renews run/<name> below the case: its constant, system, reference and 0.orig, without what the programs have written there, and the changes of the
/// variant. Whatever else a folder of that name has stays. Returns the folder's path relative to the case. Throws CaseError where the case has no such variant.
std::filesystem::path cloneCase(const std::filesystem::path& caseFolder, const std::string& name);

}
