/// Heat conduction and buoyancy of a scene, as constant/thermophysicalProperties states them.
#pragma once
#include "models/thermal/ThermalProperties.hpp"
#include "scene/Model.hpp"

namespace sph
{

inline constexpr const char* thermophysicalProperties = "constant/thermophysicalProperties";

/// Entries of README.md. Mistakes go to the case's Diagnostics.
ThermalProperties readThermal(const Reading&);
EntryList thermalEntries();

}
