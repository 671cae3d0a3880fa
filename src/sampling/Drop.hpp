/// The particles of one phase as a drop: its volume and centre, also where it lies across a periodic boundary.
#pragma once
#include "ParticleView.hpp"

namespace sph
{

struct Drop
{
    std::size_t phase = 0, particles = 0;
    double volume = 0; ///< [m^3], in 2-D [m^2]
    Vector<3> centre;

    Drop(const ParticleView&, std::size_t phase);
};

/// b - a to the nearest periodic copy of b.
Vector<3> displacement(const ParticleView&, const Vector<3>& a, const Vector<3>& b);

/// [m^dimension] of the domain.
double domainVolume(const Geometry&);

}
