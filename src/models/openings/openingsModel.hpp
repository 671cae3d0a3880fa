/// The model of open boundaries, inlets and outlets.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& openingsModel();

}
