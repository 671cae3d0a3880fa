/// The particles of one phase, or of all others, as a drop: its volume and centre, also where it lies across a periodic boundary.
#pragma once
#include "sampling/ParticleView.hpp"

namespace sph
{

struct Drop
{
    std::size_t phase = 0, particles = 0;
    bool ofOthers = false;
    double volume = 0; ///< [m^3], in 2-D [m^2]
    Vector<3> centre;

    Drop(const ParticleView&, std::size_t phase, bool ofOthers = false);
    bool has(const ParticleView&, std::size_t particle) const;
    /// Radius of the ball, in 2-D the disc, of the drop's volume [m].
    double radius(int dimension) const;
    /// Largest distance of its particles from its centre [m].
    double reach(const ParticleView&) const;
};

/// A drop of the phase, or the bubble that others make in it: of the two sides the one that reaches less far from its own centre. What is smaller than
/// the kernel's support is no bubble.
Drop dropOrBubble(const ParticleView&, std::size_t phase);

/// b - a to the nearest periodic copy of b.
Vector<3> displacement(const ParticleView&, const Vector<3>& a, const Vector<3>& b);

/// [m^dimension] of the domain.
double domainVolume(const Geometry&);

}
