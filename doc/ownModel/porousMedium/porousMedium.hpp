/// The model of a porous medium.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& porousMediumModel();

}
