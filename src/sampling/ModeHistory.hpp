#pragma once
#include "Dictionary.hpp"
#include <vector>

namespace sph
{

/// Amplitudes of a mode as a run goes on, from the time `from` on. A run that is restarted begins a new history: rates need no common origin.
struct ModeHistory
{
    double from; ///< [s]
    std::vector<double> times, amplitudes;

    /// from 0
    explicit ModeHistory(const Dictionary& d) : from(d.getNonNegative("from", units::s, 0)) {}
    void add(double time, double amplitude)
    {
        if (time < from) return;
        times.push_back(time);
        amplitudes.push_back(amplitude);
    }
};

}
