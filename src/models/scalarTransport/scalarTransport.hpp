/// The model of transported scalars.
#pragma once
#include "Model.hpp"

namespace sph
{

const Model& scalarTransportModel();

}
