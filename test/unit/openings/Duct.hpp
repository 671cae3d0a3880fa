/// Ducts along x, 3 long from x = -1, and an inlet at x = 0.
#pragma once
#include "models/openings/Opening.hpp"

namespace sph::test
{

inline Geometry duct(const std::string& text)
{
    const auto diagnostics = std::make_shared<Diagnostics>();
    const auto geometry = readGeometry(Dictionary::parse(text, "constant/geometry", diagnostics), 0.3);
    diagnostics->throwIfAny();
    return geometry;
}

/// Between y = 0 and y = width.
inline Geometry channel(double width)
{
    return duct("dimension 2; domain { min (-1 0 0); max (2 " + std::to_string(width) +
                " 0); } walls { low { type plane; point (0 0 0); normal (0 1 0); } high { type plane; point (0 " + std::to_string(width) +
                " 0); normal (0 -1 0); } }");
}
inline Geometry squareDuct()
{
    return duct("dimension 3; domain { min (-1 0 0); max (2 1 1); } walls { side { type box; min (-9 0 0); max (9 1 1); fluid inside; } }");
}
inline Geometry roundPipe(double radius)
{
    return duct(
        "dimension 3; domain { min (-1 -0.6 -0.6); max (2 0.6 0.6); } walls { side { type cylinder; point (0 0 0); axis (1 0 0); radius " +
        std::to_string(radius) + "; fluid inside; } }");
}

inline Opening inlet()
{
    Opening opening;
    opening.name = "gate";
    opening.normal = {1, 0, 0};
    opening.velocity = 1;
    return opening;
}

}
