#pragma once
#include "EntryList.hpp"

namespace sph
{

/// All files of a case with the entries that they may have.
const EntryRegistry& reference();

}
