/// The model of walls: rules for ghosts, and contact.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& wallsModel();

}
