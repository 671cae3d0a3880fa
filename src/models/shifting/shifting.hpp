/// The model of particle shifting and transport velocity.
#pragma once
#include "Model.hpp"

namespace sph
{

const Model& shiftingModel();

}
