#pragma once
#include "Model.hpp"

namespace sph
{

const Model& labelsModel();

}
