#pragma once
#include "Dictionary.hpp"

namespace sph
{

/// Adds the entries of `defaults` that a dictionary lacks; sub-dictionaries merge. They keep their own place, and are never reported as unused.
void addDefaults(const Dictionary&, const Dictionary& defaults);

}
