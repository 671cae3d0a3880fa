/// Particles of a cloud on disk, as surfaces and pictures need them.
#pragma once
#include "base/CaseError.hpp"
#include "case/Cloud.hpp"
#include "surfaces/ColourFunction.hpp"
#include <string>
#include <vector>

namespace sph
{

/// The particles of a cloud as phase number `phase` of so many sees them. Volumes are m/rho where the cloud has a mass `m`, else
/// `uniformVolume`; without a field `phase` all particles are of phase 0. Throws CaseError where a value cannot be.
PhaseParticles phaseParticles(const Cloud&, int phase, std::size_t phases, double uniformVolume);

/// One number per particle to colour by: a scalar or label field, the magnitude of a vector field.
/// Where there is no such field, an error with the fields that there are is recorded at `where`, and zeros are returned.
std::vector<double> colouringValues(const Cloud&, const std::string& field, const Location& where, Diagnostics&);

}
