/// History of the amplitude of a mode, to which rates are fitted.
#pragma once
#include "dictionary/EntryList.hpp"
#include <vector>

namespace sph
{

namespace entry
{
const Scalar from{"from", units::s, 0, nonNegative, "time from which on samples add to the fit"};
}

/// Amplitudes of a mode as a run goes on, from the time `from` on.
struct ModeHistory
{
    double from; ///< [s]
    std::vector<double> times, amplitudes;

    explicit ModeHistory(const Dictionary& d) : from(entry::from(d)) {}
    void add(double time, double amplitude)
    {
        if (time < from) return;
        if (!times.empty() && time <= times.back()) // a restarted run samples the time of its folder again
        {
            amplitudes.back() = amplitude;
            return;
        }
        times.push_back(time);
        amplitudes.push_back(amplitude);
    }
    std::vector<std::vector<double>*> lists() { return {&times, &amplitudes}; }
};

}
