/// The model of transported scalars.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

const Model& scalarTransportModel();

}
