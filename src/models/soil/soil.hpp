/// Soil as a model: src/models/soil/README.md.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& soilModel();

}
