/// How far particles may go in a step whose pressure is solved for: s h, s = 0.2 (`flowFactor`), h half the support.
#pragma once
#include "scene/Settings.hpp"

namespace sph
{

/// [m]; `support` [m].
inline double wayByFlow(const StepFactors& factors, double support) { return factors.flow * 0.5 * support; }

}
