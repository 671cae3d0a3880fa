/// Measure: the contact angle of a drop on a wall.
#pragma once
#include "sampling/Measurement.hpp"

namespace sph
{

/// Angle between a wall, plane or equally curved all around, and the surface of a drop on it, through the drop
///
///   cos theta = -h/R - k (R^2 - h^2)/(2 R)
///
/// R [m] radius of the circle or sphere fitted to the line where the drop's volume fraction is 1/2, h [m] height of its centre
/// above the wall, k [1/m] the wall's curvature, negative for fluid outside a sphere (Shape.hpp). Only points more than `above` spacings from the wall are fitted: nearer, the profile of a diffuse interface
/// bends, and base and height of the drop would give an angle up to 10 degrees off. The volume fraction is the kernel mean of
/// the phase; where the gas is left out, the kernel sum of V W.
class ContactAngle
{
    std::size_t phase_;
    std::string name_, around_; ///< of two phases
    double angle_, above_;      ///< [degrees], negative: that of the wall; [spacings]

public:
    static EntryList entries();
    ContactAngle(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Measurement operator()(const ParticleView&) const;
};

}
