/// The model of the pressure: state equation, gradient and background pressure.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& pressureModel();

}
