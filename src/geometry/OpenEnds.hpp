/// Planes at which a scene ends at its openings, for users of stored particles: pictures, volumes and means are of the scene alone, without buffer particles.
/// Positions alone say which particles are held. Verified by test/unit/openings and test/unit/sampling.
#pragma once
#include "case/Case.hpp"
#include "geometry/OpenPlane.hpp"
#include "kernels/Resolution.hpp"

namespace sph
{

class OpenEnds
{
    std::vector<OpenPlane> planes_;
    const Geometry& geometry_;
    double spacing_, depth_; ///< depth_: of what is held for forces alone [m]

public:
    /// Reads the planes of constant/openings, and none of the other entries there; mistakes go to the case's Diagnostics. The geometry must outlive this.
    OpenEnds(const Case&, const Geometry&, const Resolution&);

    bool none() const { return planes_.empty(); }
    /// The nearest plane, and the distance from it, as below; null where there is none.
    std::pair<const OpenPlane*, double> nearest(const Vector<3>& x) const;
    /// Distance from the nearest plane, of those that are open where x stands before or behind them [m]: < 0 beyond it, infinite where there is none.
    double distance(const Vector<3>& x) const { return nearest(x).second; }
    bool beyond(const Vector<3>& x) const { return distance(x) < 0; }
};

}
