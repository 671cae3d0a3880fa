/// Surface tension of a scene, for function objects that compare with capillary theory.
#pragma once
#include "ParticleView.hpp"

namespace sph
{

/// gamma of two phases [N/m]; 0 where the scene has none.
inline double surfaceTensionOf(const ParticleView& view, std::size_t a = 0, std::size_t b = 1)
{
    const auto sigma = view.constants.find("sigma");
    const std::size_t n = view.phases.size();
    return sigma == view.constants.end() || a >= n || b >= n ? 0 : sigma->second.at(a * n + b);
}

}
