/// Particles and spaces for the tests of surfaces; lengths in spacings.
#pragma once
#include "surfaces/ColourFunction.hpp"
#include <cmath>
#include <functional>

namespace sph::test
{

inline constexpr double support = 3, step = 0.5;

constexpr double cube(double a) { return a * a * a; }

inline Geometry space(int dimension, Vector<3> low, Vector<3> high)
{
    Geometry g;
    g.dimension = dimension;
    g.low = low;
    g.high = high;
    return g;
}

/// One particle in the middle of each unit cell of the domain that `kept` (wall distance) allows; `inPhase` colours it. Where
/// `gas` is false the others are left out.
inline PhaseParticles lattice(const Geometry& g, const std::function<bool(Vector<3>)>& inPhase, bool gas = true)
{
    PhaseParticles particles;
    const double z0 = g.dimension == 2 ? 0 : g.low.z + 0.5, z1 = g.dimension == 2 ? 0.5 : g.high.z;
    for (double z = z0; z < z1; ++z)
        for (double y = g.low.y + 0.5; y < g.high.y; ++y)
            for (double x = g.low.x + 0.5; x < g.high.x; ++x)
            {
                const Vector<3> at{x, y, z};
                if (g.distance(at) < 0 || (!gas && !inPhase(at))) continue;
                particles.position.push_back(at);
                particles.volume.push_back(1);
                particles.inPhase.push_back(inPhase(at));
            }
    return particles;
}

/// Inside a ball (3-D) or disc (2-D).
inline auto ball(Vector<3> centre, double R)
{
    return [=](Vector<3> x) { return mag(x - centre) < R; };
}

}
