/// Processor and wall time since the start, as the last lines of each step in a solver's log.
#pragma once
#include <chrono>
#include <ctime>

namespace sph
{

class Clock
{
    std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();

public:
    /// Processor time of the process, all threads together [s].
    static double executionTime() { return double(std::clock()) / CLOCKS_PER_SEC; }

    /// Wall time since this clock was made [s].
    double clockTime() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count(); }
};

}
