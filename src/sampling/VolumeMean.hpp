/// Mean over particles, weighted with their volumes: sum V f/sum V. With `sum` and `groupSums` of reduce.hpp.
#pragma once
#include <cstddef>
#include <limits>

namespace sph
{

template<class T = double> struct VolumeMean
{
    double volume = 0; ///< sum V
    T amount{};        ///< sum V f
    std::size_t particles = 0;

    static VolumeMean of(double V, const T& f) { return {V, V * f, 1}; }
    VolumeMean& operator+=(const VolumeMean& other)
    {
        volume += other.volume;
        amount += other.amount;
        particles += other.particles;
        return *this;
    }
    /// NaN without particles.
    T value() const { return amount / (particles > 0 ? volume : std::numeric_limits<double>::quiet_NaN()); }
};

}
