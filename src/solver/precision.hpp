/// The word `precision` of system/sphSchemes: in which the terms of pairs are computed.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& precisionModel();

}
