/// A scene run in steps as long as they are stable.
#pragma once
#include "solver/Simulation.hpp"
#include <algorithm>

namespace sph::test
{

/// From the time 0 to `end` [s], in no step longer than `longest`.
inline void runTo(AnySimulation& simulation, double end, double longest = 1)
{
    for (double time = 0; time < end * (1 - 1e-9);)
    {
        const double deltaT = std::min({simulation.stepLimit().deltaT, end - time, longest});
        simulation.step(time, deltaT);
        time += deltaT;
    }
}

}
