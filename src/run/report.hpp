/// The log of a run: it says the plan at the start, and what each reported step was like.
#pragma once
#include "base/Clock.hpp"
#include "solver/Monitor.hpp"

namespace sph
{

void reportPlan(std::ostream& log, const Settings&, AnySimulation&);
/// All ranks have to report: the particle that the step waits for is sought among all of theirs.
void reportStep(std::ostream& log, const Settings&, const AnySimulation&, const RunTime&, const Monitor&, const Clock&, const StepLimit&,
                double deltaT);

}
