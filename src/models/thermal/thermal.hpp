/// The model of heat conduction and buoyancy.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& thermalModel();

}
