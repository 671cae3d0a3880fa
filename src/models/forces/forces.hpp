/// The model of gravity, body force, shaking and damping.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& forcesModel();

}
