/// The model of density and volume: number density, or the continuity equation with diffusion.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& densityModel();

}
