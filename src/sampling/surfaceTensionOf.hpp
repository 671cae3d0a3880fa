/// Surface tension of a scene, for function objects that compare with capillary theory.
#pragma once
#include "sampling/ParticleView.hpp"

namespace sph
{

/// gamma of two phases [N/m], or of one phase whose gas is left out; 0 where the scene has none.
inline double surfaceTensionOf(const ParticleView& view, std::size_t a = 0, std::size_t b = 1)
{
    const auto sigma = view.constants.find("sigma");
    if (sigma == view.constants.end()) return 0;
    const std::size_t pair = sigma->second.size() == 1 ? 0 : a * view.phases.size() + b;
    return pair < sigma->second.size() ? sigma->second[pair] : 0;
}

}
