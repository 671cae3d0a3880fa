#include "models/scalarTransport/mirrorsPairwise.hpp"
#include <cmath>
#include <limits>

namespace sph
{

bool mirrorsPairwise(const Geometry& geometry)
{
    if (!geometry.layers.empty()) return false;
    std::vector<Vector<3>> normals;
    for (const auto& patch : geometry.patches)
    {
        if (patch.shape->smallestRadius() < std::numeric_limits<double>::infinity() || patch.shape->hasEdges()) return false;
        normals.push_back(patch.shape->foot({}).normal);
    }
    const double roundOff = 1e-12;
    for (const auto& a : normals)
        for (const auto& b : normals)
            if (const double along = std::abs(dot(a, b)); along > roundOff && along < 1 - roundOff) return false;
    return true;
}

}
