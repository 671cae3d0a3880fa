/// The flow limit of steps whose pressure is solved for: a particle goes no farther than s h, s = 0.2 (`flowFactor`), h half the support.
#pragma once
#include "scene/Settings.hpp"

namespace sph
{

/// [m]; `support` [m].
inline double wayByFlow(const StepFactors& factors, double support) { return factors.flow * 0.5 * support; }

}
