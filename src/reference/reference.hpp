/// The reference of all files of a case and their entries.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{

/// All files of a case with the entries that they may have.
const EntryRegistry& reference();

}
