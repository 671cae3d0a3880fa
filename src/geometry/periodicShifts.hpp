/// The ways to the neighbouring periods of a domain.
#pragma once
#include "geometry/Geometry.hpp"

namespace sph
{

/// f(by) for a shift by -1, 0 or 1 periods in each periodic direction, all but none at all; in a fixed order.
template<class F> void forEachPeriodicShift(const Geometry& g, const F& f)
{
    const std::array<int, 3> most{g.periodic[0], g.periodic[1], g.periodic[2]};
    for (int i = -most[0]; i <= most[0]; ++i)
        for (int k = -most[1]; k <= most[1]; ++k)
            for (int l = -most[2]; l <= most[2]; ++l)
                if (i != 0 || k != 0 || l != 0) f(Vector<3>{i * g.length(0), k * g.length(1), l * g.length(2)});
}

}
