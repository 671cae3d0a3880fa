/// Default entries of a dictionary, merged into it.
#pragma once
#include "dictionary/Dictionary.hpp"

namespace sph
{

/// Adds the entries of `defaults` that a dictionary lacks; sub-dictionaries merge. They keep their own place, and are never reported as unused.
void addDefaults(const Dictionary&, const Dictionary& defaults);

/// Whether an entry came that way: what acts in silence where it suits, and is no word of the user's where it does not.
bool isDefault(const Dictionary&, const std::string& key);

}
