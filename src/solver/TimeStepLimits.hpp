/// Limits of the time step: those that models state, each in its own room, and those of their parts. Where a step has substeps
/// (`maxSubSteps`) the limits of what acts in each are as many times as long.
#pragma once
#include "scene/Model.hpp"

namespace sph
{

/// All limits that apply; `ofParts` come first.
std::vector<StepLimit> stepLimits(const Settings&, const Measured&, std::vector<StepLimit> ofParts = {});
/// The least odd number of parts that brings each within its limit.
int partsOf(double deltaT, const Settings&, const std::vector<StepLimit>&);
/// The least; infinity by "none" where there is none.
StepLimit leastOf(const std::vector<StepLimit>&);

}
