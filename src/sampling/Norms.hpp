/// Norms of a field over particles, weighted with their volumes: L1 = sum V |e|/sum V, L2 = (sum V e^2/sum V)^1/2, Linf = max
/// |e|.
#pragma once
#include "parallel/reduce.hpp"
#include <cmath>

namespace sph
{

struct Norms
{
    double L1 = 0, L2 = 0, Linf = 0;
};

class NormSum
{
    double volume_ = 0, first_ = 0, second_ = 0, largest_ = 0;

public:
    NormSum() = default;
    NormSum(double volume, double magnitude)
        : volume_(volume), first_(volume * magnitude), second_(volume * magnitude * magnitude), largest_(magnitude)
    {}
    NormSum& operator+=(const NormSum& other)
    {
        volume_ += other.volume_;
        first_ += other.first_;
        second_ += other.second_;
        Larger{}(largest_, other.largest_);
        return *this;
    }

    /// NaN of nothing.
    Norms norms() const { return {first_ / volume_, std::sqrt(second_ / volume_), volume_ > 0 ? largest_ : first_ / volume_}; }
};

/// error/scale, 0 where both are 0: fluid at rest that should be at rest has no error.
inline double relativeTo(double scale, double error) { return error == 0 ? 0 : error / scale; }

inline Norms relativeTo(const Norms& scale, const Norms& e)
{
    return {relativeTo(scale.L1, e.L1), relativeTo(scale.L2, e.L2), relativeTo(scale.Linf, e.Linf)};
}

}
