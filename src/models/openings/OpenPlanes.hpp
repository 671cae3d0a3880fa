/// Planes at which a scene ends at its openings, for users of stored particles: pictures, volumes and means are of the scene alone, without buffer particles.
/// Positions alone say who is held. Verified by test/unit/openings and test/unit/sampling.
#pragma once
#include "kernels/Resolution.hpp"
#include "models/openings/Opening.hpp"
#include <vector>

namespace sph
{

/// Whether the plane of an opening is in sight along its normal from a point of the duct beyond it.
bool inSight(const Opening&, const Geometry&, const Vector<3>& x, double spacing);

class OpenPlanes
{
    std::vector<Opening> openings_;
    const Geometry& geometry_;
    double spacing_, depth_; ///< depth_: of what is held for forces alone [m]

public:
    /// Reads constant/openings; mistakes go to the case's Diagnostics. The geometry must outlive this.
    OpenPlanes(const Case&, const Geometry&, const Resolution&, const std::vector<std::string>& phases);

    bool none() const { return openings_.empty(); }
    /// Distance from the nearest plane, of those that are open where x stands before or behind them [m]: < 0 beyond it, infinite where there is none.
    double distance(const Vector<3>& x) const;
    bool beyond(const Vector<3>& x) const { return distance(x) < 0; }
};

}
