/// The model of surface tension and contact angles.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& tensionModel();

}
