/// Terms of heat conduction and buoyancy.
#pragma once
#include "models/thermal/ThermalProperties.hpp"
#include "scene/Settings.hpp"

namespace sph
{

/// kappa_ij/Cp_i of all pairs of phases, phases x phases, i first [kg/(m s)].
std::vector<double> pairConductivitiesOverCp(const ThermalProperties&);

/// Defines the conduction of heat in the scene, and the heat received from each wall of given temperature or heat flux; returns the names of the terms.
/// `byWall`: ghosts differ by their HeatedWall.
std::vector<std::string> defineConduction(Settings&, const ThermalProperties&, bool byWall);

/// Defines buoyancy, part of the force that the wall's velocity rule sees where the scene sums that apart, and returns its name.
std::string defineBuoyancy(Settings&, const ThermalProperties&);

}
