/// Measures: the shape of a liquid lens between two phases.
#pragma once
#include "sampling/Measurement.hpp"
#include <array>

namespace sph
{

/// A drop of a third phase that floats between two others, without gravity: its two surfaces are circular arcs (caps of spheres in 3-D) on a common
/// chord, in line with the plane interface of the other two. At their edge the three tensions balance (Neumann's triangle),
///
///   gamma_12 = gamma_1 cos(theta_1) + gamma_2 cos(theta_2),    gamma_1 sin(theta_1) = gamma_2 sin(theta_2)
///   V = a^2 sum_b (theta_b - sin(theta_b) cos(theta_b))/sin^2(theta_b)    in 2-D
///   V = pi a^3 sum_b (2 - 3 cos(theta_b) + cos^3(theta_b))/(3 sin^3(theta_b))    in 3-D
///
/// gamma_b [N/m] tension of the lens's surface towards phase b, theta_b angle between that and the chord, through the lens; gamma_12 of the others;
/// V [m^3] (2-D: m^2) volume of the lens, a [m] half its chord.
///
/// Circles are fitted to where the lens's volume fraction is 1/2, but for what lies within the kernel's support of the third phase (its
/// fraction above `clear`), where the smoothed interfaces of three phases have no angle; theta_b and a are those of the fitted circles at their
/// intersection.
class LiquidLens
{
protected:
    std::size_t phase_;
    std::array<std::size_t, 2> around_{};
    double clear_;

    struct Shape
    {
        std::array<double, 2> angle{}; ///< [degrees]
        double a = 0;                  ///< [m]
        std::size_t particles = 0;
        std::string note; ///< why there is no shape
    };
    Shape fitted(const ParticleView&) const;
    Shape exact(const ParticleView&) const;

public:
    LiquidLens(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
};

/// theta_b [degrees] towards the phase `towards`.
class LensAngle : LiquidLens
{
    std::size_t side_;

public:
    static EntryList entries();
    LensAngle(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Measurement operator()(const ParticleView&) const;
};

/// a [m]
class LensRadius : LiquidLens
{
public:
    static EntryList entries();
    using LiquidLens::LiquidLens;
    Measurement operator()(const ParticleView&) const;
};

}
