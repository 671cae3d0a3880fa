/// Measure: the decay rate of Taylor and Green's vortices.
#pragma once
#include "sampling/Measurement.hpp"
#include "sampling/TaylorGreen.hpp"

namespace sph
{

/// Rate at which Taylor & Green's vortices decay, against 2 nu k^2 = 8 pi^2 nu/L^2 [1/s]:
///
///   rate = -ln A/t,    A = sum V_i u_i.e_i/sum V_i e_i.e_i,    e the exact velocity at t = 0
///
/// A is the amplitude of the flow's own part that has the right shape: what particles jitter besides does not enter. At t = 0 there is no
/// rate yet.
class VortexDecay
{
    TaylorGreen start_;
    double rate_;

public:
    static EntryList entries();
    VortexDecay(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Measurement operator()(const ParticleView&) const;
};

}
