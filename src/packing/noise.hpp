/// Repeatable noise: a number that depends on a seed and a counter alone, so that neither the order of a loop nor the number of
/// threads changes it.
#pragma once
#include <cstdint>

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

}
