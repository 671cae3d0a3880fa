/// Part of the scene into which a mesh must fit.
#pragma once
#include "base/Vector.hpp"
#include <array>

namespace sph
{

struct MeshSpace
{
    Vector<3> low, high; ///< the domain
    std::array<bool, 3> periodic{};
    double spacing = 0, H = 0; ///< [m]
};

}
