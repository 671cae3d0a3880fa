/// What a step throws that may succeed in shorter ones.
#pragma once
#include "base/DivergedError.hpp"

namespace sph
{

/// A solve has no answer for the length of the step, on all ranks alike. Where the integrator can take the step back it is made again in halves; elsewhere
/// the run has diverged.
class StepTooLong : public DivergedError
{
public:
    using DivergedError::DivergedError;
};

}
