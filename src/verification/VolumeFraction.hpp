/// Volume fraction of a phase, sampled from particles.
#pragma once
#include "sampling/Interpolator.hpp"
#include <optional>

namespace sph
{

/// Volume fraction of a phase at points: the kernel mean of the phase; where the gas is left out, the kernel sum of V W.
class VolumeFraction
{
    const ParticleView& view_;
    Interpolator interpolator_;
    std::size_t phase_;

public:
    /// Keeps a reference to the view.
    VolumeFraction(const ParticleView& view, std::size_t phase) : view_(view), interpolator_(view), phase_(phase) {}
    double operator()(const Vector<3>& x) const;
    /// Distance along a unit vector at which the fraction first falls below 1/2, found from half a spacing to half a spacing; none within
    /// `reach`.
    std::optional<double> surface(const Vector<3>& from, const Vector<3>& direction, double reach) const;
};

}
