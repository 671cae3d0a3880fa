/// Gas whose motion nobody asks for: calm, in a band, slowed by a friction, or left out: the model.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& gasModel();

}
