#include "sampling/viewOfScene.hpp"

namespace sph
{

ParticleView viewOfScene(const Coefficients& c, const Vector<3>& gravity, const std::string& kernel, const Geometry& geometry)
{
    ParticleView v;
    v.dimension = geometry.dimension;
    v.phases = c.phases;
    v.restDensity = c.restDensity;
    v.soundSpeed = c.soundSpeed;
    v.viscosity = c.viscosity;
    v.constants = c.constants;
    v.gravity = gravity;
    v.bodyForce = c.bodyForce;
    v.g = gravity + c.bodyForce / c.restDensity[0];
    v.spacing = c.spacing;
    v.support = c.support;
    v.kernel = kernel;
    v.geometry = &geometry;
    return v;
}

}
