/// Rates of the parts on the jittered block, each timed in turns with the yardstick: the force pass, and the list build.
#pragma once
#include "measure.hpp"

namespace sph
{

/// `skin` [spacings]: lists that reach beyond the support, as in a run.
Figures forcePass(PairLimit& limit, double skin);

}
