/// The model of labels that particles keep for life.
#pragma once
#include "Model.hpp"

namespace sph
{

const Model& labelsModel();

}
