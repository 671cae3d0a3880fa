/// Gas that is left out where nobody asks for its motion: the model.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& gasModel();

}
