/// The model of labels that particles keep for life.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& labelsModel();

}
