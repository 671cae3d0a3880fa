/// Selection of the candidates within a radius from a run of them: the inner loop of list building.
///
/// GCC 12 does not vectorise a loop that appends; a compress in registers does it (the form of AVX-512 that writes to memory is slow on some
/// machines).
#pragma once
#include "base/Vector.hpp"
#include "neighbours/lanes.hpp"

namespace sph
{

/// Writes order[b] for every b in [begin, end) with |x_b - x| < radius to `out` and returns their number. `out` needs room for 8 more.
template<int dim, class L = WidestLanes>
inline int selectWithin(const double* const (&position)[dim], const int* order, int begin, int end, Vector<dim> x, double radiusSqr,
                        int* out)
{
    using Doubles = typename L::Doubles;
    const Doubles limit = L::all(radiusSqr);
    int found = 0;
    const auto select = [&](const auto& load, unsigned lanes) __attribute__((always_inline))
    {
        const Doubles dx = load(position[0]) - x.x, dy = load(position[1]) - x.y;
        Doubles rSqr = dx * dx + dy * dy;
        if constexpr (dim == 3)
        {
            const Doubles dz = load(position[2]) - x.z;
            rSqr += dz * dz;
        }
        const unsigned bits = L::bits(L::less(rSqr, limit)) & lanes;
        L::store(out + found, L::compress(load(order), bits));
        found += std::popcount(bits);
    };
    int b = begin;
    for (; b + L::count <= end; b += L::count)
        select(
            [&]<class T>(const T* from)
            {
                if constexpr (std::is_same_v<T, int>) return L::template load<typename L::Ints>(from + b);
                else return L::template load<Doubles>(from + b);
            },
            ~0u);
    if (b < end) select([&](const auto* from) { return L::loadFirst(from + b, end - b); }, (1u << (end - b)) - 1);
    return found;
}

}
