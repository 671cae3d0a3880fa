/// The model of particle shifting and transport velocity.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& shiftingModel();

}
