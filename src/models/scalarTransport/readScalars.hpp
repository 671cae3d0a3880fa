/// The scalars of a scene, as constant/scalarTransport declares them.
#pragma once
#include "models/scalarTransport/TransportedScalar.hpp"
#include "scene/Model.hpp"

namespace sph
{

/// One dictionary a scalar, README.md. Mistakes go to the case's Diagnostics.
std::vector<TransportedScalar> readScalars(const Reading&);
EntryList scalarEntries();

}
