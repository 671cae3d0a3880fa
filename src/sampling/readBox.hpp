/// A box within the domain, `min` and `max` of a function object: all of the domain unless given.
#pragma once
#include "Geometry.hpp"
#include "components.hpp"
#include <fmt/format.h>

namespace sph
{

inline Box readBox(const Dictionary& d, const Geometry& g)
{
    const Box box{d.getVector("min", units::m, g.low), d.getVector("max", units::m, g.high)};
    for (int k = 0; k < g.dimension; ++k)
        if (const auto c = component(k); !(box.high.*c > box.low.*c))
            d.error("max", fmt::format("max must be greater than min; in {} it is {} against {}", coordinateNames[k], box.high.*c, box.low.*c));
    return box;
}

}
