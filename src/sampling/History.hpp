/// History of a number, to which laws are fitted.
#pragma once
#include "dictionary/EntryList.hpp"
#include <limits>
#include <vector>

namespace sph
{

namespace entry
{
const Scalar from{"from", units::s, 0, nonNegative, "time from which on rows count"},
    to{"to", units::s, byScene("the end"), nonNegative, "time until which rows count"};
}

/// Values of a number as a run goes on, between the times `from` and `to`.
struct History
{
    double from = 0, to = std::numeric_limits<double>::infinity(); ///< [s]
    std::vector<double> times, values;

    History() = default;
    explicit History(const Dictionary& d) : from(entry::from(d)), to(entry::to(d, std::numeric_limits<double>::infinity())) {}
    void add(double time, double value)
    {
        if (time < from || time > to) return;
        if (!times.empty() && time <= times.back()) // a restarted run samples the time of its folder again
        {
            values.back() = value;
            return;
        }
        times.push_back(time);
        values.push_back(value);
    }
    /// The first time at which the values have gone past a level, from below or from above, between two of them in proportion; NaN while there is none.
    double passage(double level) const
    {
        for (std::size_t k = 1; k < times.size(); ++k)
            if (const double before = values[k - 1] - level, after = values[k] - level; before * after <= 0 && before != after)
                return times[k - 1] + before / (before - after) * (times[k] - times[k - 1]);
        return std::numeric_limits<double>::quiet_NaN();
    }
    std::vector<std::vector<double>*> lists() { return {&times, &values}; }
};

}
