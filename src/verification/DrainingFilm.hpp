/// Measure: how thick a film on a horizontal cylinder is as it drains.
#pragma once
#include "sampling/Measurement.hpp"
#include <vector>

namespace sph
{

/// Mean thickness h = b - a [m] of the film within an angle from the top of a horizontal cylinder of radius a, from the volume of the phase there, against lubrication theory of a film that had this volume when
/// it was first measured and was as thick everywhere:
///
///   d/dt (b^2 - a^2)/2 + d/dtheta (q sin theta) = 0,   q = (g b/nu) (b^2 (b^2 - a^2)/(8 a^2) + (b^2 - a^2)/8 - b^2/2 ln(b/a))
///
/// theta [rad] from the top, where gravity points down, nu [m^2/s] of the phase. q tends to that of Nusselt, g h^3/(3 nu). By finite volumes, upwind, from the top on.
class DrainingFilm
{
    std::size_t phase_;
    Vector<3> origin_, axis_;
    double radius_, within_, parts_; ///< [m], [rad], [-]
    std::vector<double> areas_;      ///< (b^2 - a^2)/2 of the cells of the theory [m^2]
    std::vector<double> times_;      ///< to which it has come [s]; none before the first row
    Location where_;

    double flow(double area, double g, double nu) const;
    void march(double until, double g, double nu);

public:
    static EntryList entries();
    DrainingFilm(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Measurement operator()(const ParticleView&);
    std::vector<std::vector<double>*> lists() { return {&areas_, &times_}; }
};

}
