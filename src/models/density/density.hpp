/// The model of density and volume: number density, or the continuity equation with diffusion.
#pragma once
#include "Model.hpp"

namespace sph
{

const Model& densityModel();

}
