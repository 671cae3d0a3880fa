/// The model of viscosity, physical and artificial.
#pragma once
#include "Model.hpp"

namespace sph
{

const Model& viscosityModel();

}
