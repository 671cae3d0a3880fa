/// The largest magnitude of many numbers, and where it is. A NaN is larger than all and stays, so that no comparison with a bound holds.
#pragma once
#include <cmath>
#include <cstddef>

namespace sph::test
{

class Largest
{
    double value_ = 0;
    std::size_t at_ = 0;

public:
    void operator()(double q, std::size_t at = 0)
    {
        if (std::abs(q) <= value_ || std::isnan(value_)) return;
        value_ = std::abs(q);
        at_ = at;
    }
    double value() const { return value_; }
    std::size_t at() const { return at_; }
};

}
