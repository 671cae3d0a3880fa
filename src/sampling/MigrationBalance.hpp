/// Measure: the balance of the fluxes of powder.
#pragma once
#include "sampling/Measurement.hpp"

namespace sph
{

/// Distance of powder from the state in which it no longer migrates, whatever the geometry, by Phillips' fluxes
///
///   J = -D_c a^2 phi^2 gammaDot grad ln(phi gammaDot mu^r),    r = D_eta/D_c
///
/// so that phi gammaDot mu^r is uniform when all is steady. The value is the largest |ln(phi gammaDot mu^r) - its mean| of the particles
/// whose shear stress mu gammaDot is at least `leastStress` times the largest: in the middle of a channel and in corners gammaDot vanishes,
/// and no particle is small enough. Its reference is 0: compare with `norm absolute;`.
class MigrationBalance
{
    double r_, leastStress_;
    Location where_;

public:
    static EntryList entries();
    MigrationBalance(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Measurement operator()(const ParticleView&) const;
};

}
