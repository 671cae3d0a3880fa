/// Measure: the contact angle of a drop by its moments.
#pragma once
#include "sampling/Measurement.hpp"

namespace sph
{

/// A drop at rest on a plane, or on top of a sphere, is a part of a ball. Its volume V and one moment of its particles give the contact angle: the height of the centre of mass, or the mean square distance from
/// the axis; where the two differ it is no such part. No surface is fitted. With r [m] the radius of the ball, on a plane
///
///   V = pi r^3 (2 + cos theta)(1 - cos theta)^2/3
///
/// and on a sphere of radius R, whose line of contact lies at the polar angle b,
///
///   r = R sin b/sin(b + theta),   V = r^3 C(b + theta) - R^3 C(b),   C(x) = pi (2 + cos x)(1 - cos x)^2/3
///
/// (de Gennes et al. 2004, Capillarity and Wetting Phenomena). The axis goes through `origin`, along the wall's normal there.
class CapAngle
{
    std::size_t phase_;
    std::string name_, around_;
    Vector<3> origin_;
    double parts_, angle_; ///< [-]; [degrees], negative: that of the wall
    bool byHeight_;
    Location where_;

public:
    static EntryList entries();
    CapAngle(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Measurement operator()(const ParticleView&) const;
};

}
