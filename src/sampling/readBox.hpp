/// A box within the domain, `min` and `max` of a function object: all of the domain unless given.
#pragma once
#include "dictionary/EntryList.hpp"
#include "geometry/Geometry.hpp"
#include "geometry/components.hpp"
#include <fmt/format.h>

namespace sph
{

namespace entry
{
const VectorParameter min{"min", units::m, byScene("that of the domain"), "lowest corner of the box"},
    max{"max", units::m, byScene("that of the domain"), "highest corner of the box"};
}

inline Box readBox(const Dictionary& d, const Geometry& g)
{
    const Box box{entry::min(d, g.low), entry::max(d, g.high)};
    for (int k = 0; k < g.dimension; ++k)
        if (const auto c = component(k); !(box.high.*c > box.low.*c))
            entry::max.error(d, fmt::format("max must be greater than min; in {} it is {} against {}", coordinateNames[k], box.high.*c,
                                            box.low.*c));
    return box;
}

}
