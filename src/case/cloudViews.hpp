/// A cloud in memory as views of its arrays, as writers and readers of particles take them.
#pragma once
#include "case/Cloud.hpp"

namespace sph
{

/// Valid as long as the cloud and its arrays are.
FieldView positionsOf(const Cloud&);
std::vector<FieldView> fieldsOf(const Cloud&);

}
