/// Measure: the growth rate of a wave on a plane interface.
#pragma once
#include "sampling/History.hpp"
#include "sampling/Measurement.hpp"

namespace sph
{

/// Growth rate [1/s] of a wave on the plane interface of two layers, against the exact root of the linear problem of two viscous fluids
/// (PlaneMode.hpp). The amplitude is that of the first phase's volume along x,
///
///   a = 2/A sum_i m_i/rho_0 cos(k x_i)
///
/// A [m^2] cross-section of the domain normal to gravity (in 2-D its length), k [1/m] a whole number of waves over the domain, with a crest or a
/// trough at x = 0. Each sample adds to the fit (ModeFit.hpp) of those since `from` for which |a| is at most `largest`.
class InterfaceGrowth
{
    std::size_t waves_;
    double depth_, largest_; ///< [m], [wavelengths]
    History history_;

public:
    /// Gravity must be along -y; the domain is periodic in x.
    static EntryList entries();
    InterfaceGrowth(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Measurement operator()(const ParticleView&);
    std::vector<std::vector<double>*> lists() { return history_.lists(); }
};

}
