/// Measure: the height of capillary rise in a slit.
#pragma once
#include "base/CaseError.hpp"
#include "geometry/Geometry.hpp"
#include "sampling/Measurement.hpp"

namespace sph
{

/// Height of the liquid in a slit between two plates above that in a reservoir beside it, against Bosanquet's equation (BosanquetRise.hpp) at
/// the time of the view; once at rest, Jurin's height. Each level is that of the phase's volume in a box, which has the box's full width below it:
/// y_min + sum_i m_i/rho_0/width. A meniscus then needs no convention: what lies above the other level is what the walls hold.
///
/// The reservoir has one wall of the same contact angle and one of 90 degrees: it is pulled with gamma cos(theta)/W.
class CapillaryRise
{
    std::size_t phase_;
    Box slit_, reservoir_;
    double foot_, start_, angle_, slipLength_; ///< [m] heights of the slit's lower end and of the levels at the start; [degrees]; [m]
    Location where_;

public:
    /// 2-D, gravity along -y.
    static EntryList entries();
    CapillaryRise(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    /// CaseError without surface tension, and of a liquid that is lighter than the gas.
    Measurement operator()(const ParticleView&) const;
};

}
