/// Measure: the drag factor of a periodic array of spheres.
#pragma once
#include "sampling/Measurement.hpp"

namespace sph
{

/// Drag of a periodic array of spheres in creeping flow, as the factor K over Stokes' law: Zick & Homsy (1982)
///
///   F = 6 pi mu a K U,  F = rho g V_cell/N,  N 4/3 pi a^3 = phi V_cell   =>   K = 2 a^2 rho g/(9 phi mu U),  k/a^2 = 2/(9 phi K)
///
/// F [N] force per sphere that balances the drive rho g [N/m^3] on the whole cell (a pressure gradient; the hydrodynamic force
/// of a drive by body force on the fluid alone lacks the buoyancy, a factor 1 - phi), a [m] radius, phi solid fraction, U [m/s]
/// superficial velocity along g, U = sum_i V_i u_i/V_cell. In 2-D, cylinders: K = F/(mu U) = rho g pi a^2/(phi mu U) per unit
/// length.
///
/// References: sc, bcc, fcc computed by periodic Stokeslets and the method of fundamental solutions, sc within 0.1 % of Zick &
/// Homsy; square arrays of cylinders from Sangani & Acrivos (1982), table 1. K is for one solid fraction: others are given by
/// `reference`.
class DragFactor
{
    std::size_t phase_;
    double radius_, solidFraction_, reference_ = 1;

public:
    static EntryList entries();
    DragFactor(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Measurement operator()(const ParticleView&) const;
};

}
