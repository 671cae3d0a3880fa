/// Reading of the settings: the dictionaries of a case, and what all models make of them.
#pragma once
#include "dictionary/EntryList.hpp"
#include "scene/Settings.hpp"

namespace sph
{

/// Reads constant/phaseProperties and constant/g, and has every model read its own; mistakes go to the case's Diagnostics.
Settings readSettings(const Case&, const Geometry&);

}
