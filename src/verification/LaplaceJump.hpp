/// Measure: the pressure jump across the surface of a drop or bubble.
#pragma once
#include "sampling/Measurement.hpp"

namespace sph
{

/// Pressure inside a drop or a bubble at rest minus that outside, against Young and Laplace's law
///
///   p_in - p_out = gamma/R in 2-D, 2 gamma/R in 3-D
///
/// gamma [N/m] surface tension, R [m] radius. p_in and p_out [Pa] are means, weighted with volume, over the particles of the
/// inside that lie deeper than the kernel's support H (r < R - H), and over those of the other side beyond r > R + H: between
/// them the pressure of a diffuse interface has no meaning. Inside is the phase, or where others make a bubble in it those
/// (Drop.hpp). Where the gas is left out p_out = 0.
class LaplaceJump
{
    std::size_t phase_;
    double radius_, sigma_; ///< 0: from the volume of the drop's particles; the scene's

public:
    static EntryList entries();
    LaplaceJump(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Measurement operator()(const ParticleView&) const;
};

}
