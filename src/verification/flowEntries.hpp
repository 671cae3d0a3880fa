/// Entries that several exact solutions of flows have.
#pragma once
#include "sampling/sharedEntries.hpp"

namespace sph::entry
{

const Direction normal{"normal", Vector<3>{0, 1, 0}, "across the flow, from the plate through origin"};
const Switch steady{"steady", false, "the steady part of the solution alone"};
const Scalar nu{"nu", units::kinematicViscosity, required, positive, "kinematic viscosity"},
    width{"width", units::m, required, positive, "distance of the plates"};
}
