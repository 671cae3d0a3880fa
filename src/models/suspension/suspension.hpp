/// The model of suspensions: viscosity and migration of powder.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& suspensionModel();

}
