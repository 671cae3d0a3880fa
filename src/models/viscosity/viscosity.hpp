/// The model of viscosity, physical and artificial.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& viscosityModel();

}
