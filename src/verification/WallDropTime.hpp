/// Measure: the time in which a field at a wall changes.
#pragma once
#include "sampling/Measurement.hpp"

namespace sph
{

/// Time at which a field at a wall has gone a share of its way, against a reference: the time scale of migration, which no steady state tells.
///
///   t:  f_w(t) = start + share (f_w(now) - start),    f_w the parabola through the means of the three rows next to the wall, at the wall
///
/// Taken anew each time; what counts is the last, when f_w(now) is steady. Rows are a particle spacing thick. Dictionary:
///
///     field phi;  start 0.55;                           // its uniform value at t = 0
///     share 0.5;  time 2.35e-4;                         // [s] the reference
///     origin (0 0 0);  normal (0 1 0);                  // of the wall, normal into the fluid
class WallDropTime
{
    std::string field_;
    double share_, reference_;
    Vector<3> origin_, normal_;
    Location where_;
    std::vector<double> times_, values_;

    double wallValue(const ParticleView&) const;

public:
    static EntryList entries();
    WallDropTime(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Measurement operator()(const ParticleView&);
    std::vector<std::vector<double>*> lists() { return {&times_, &values_}; }
};

}
