/// Repeatable noise: a number that depends on a seed and a counter alone, so that neither the order of a loop nor the number of
/// threads changes it.
#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

namespace sph
{

/// Uniform in [0, 1): the finaliser of SplitMix64 (Steele, Lea & Flood 2014) applied to seed and counter.
inline double noise(std::uint64_t seed, std::uint64_t counter)
{
    std::uint64_t z = (seed + 1) * 0x9e3779b97f4a7c15u + counter * 0xd1342543de82ef95u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return double((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/// One number after another of a seed.
class Noise
{
    std::uint64_t seed_, counter_ = 0;

public:
    explicit Noise(std::uint64_t seed) : seed_(seed) {}
    /// Uniform in [0, 1)
    double operator()() { return noise(seed_, counter_++); }
    double between(double low, double high) { return low + (high - low) * (*this)(); }
    /// Mean 0, standard deviation 1 (Box & Muller 1958)
    double normal()
    {
        const double radius = std::sqrt(-2 * std::log(1 - (*this)()));
        return radius * std::cos(2 * std::numbers::pi * (*this)());
    }
    int below(int n) { return int(n * (*this)()); }
};

}
