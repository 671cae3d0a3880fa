/// From the dictionaries of a case to what all models make of them.
#pragma once
#include "EntryList.hpp"
#include "Settings.hpp"

namespace sph
{

/// Reads constant/phaseProperties and constant/g, and has every model read its own; mistakes go to the case's Diagnostics.
Settings readSettings(const Case&, const Geometry&);

}
