/// History of a number, to which laws are fitted.
#pragma once
#include "dictionary/EntryList.hpp"
#include <vector>

namespace sph
{

namespace entry
{
const Scalar from{"from", units::s, 0, nonNegative, "time from which on rows count"};
}

/// Values of a number as a run goes on, from the time `from` on.
struct History
{
    double from = 0; ///< [s]
    std::vector<double> times, values;

    History() = default;
    explicit History(const Dictionary& d) : from(entry::from(d)) {}
    void add(double time, double value)
    {
        if (time < from) return;
        if (!times.empty() && time <= times.back()) // a restarted run samples the time of its folder again
        {
            values.back() = value;
            return;
        }
        times.push_back(time);
        values.push_back(value);
    }
    std::vector<std::vector<double>*> lists() { return {&times, &values}; }
};

}
