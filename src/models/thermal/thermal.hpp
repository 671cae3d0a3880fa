/// The model of heat conduction and buoyancy.
#pragma once
#include "Model.hpp"

namespace sph
{

const Model& thermalModel();

}
