/// Measure: the growth rate of a wave on a liquid column.
#pragma once
#include "sampling/History.hpp"
#include "sampling/Measurement.hpp"

namespace sph
{

/// Growth rate [1/s] of an axisymmetric wave on a liquid column along z, against the exact root of the linear problem of two viscous fluids
/// (ColumnMode.hpp). The amplitude is that of the column's volume along it,
///
///   a/R = 1/(pi R^2 L) sum_i m_i/rho_0 cos(k z_i)
///
/// R [m] radius of a column of the phase's volume, L [m] length of the domain, k = 2 pi/L, with the neck or the bulge at z = 0. Each sample adds
/// to the fit (ModeFit.hpp) of those since `from` for which |a|/R is at most `largest`.
class ColumnGrowth
{
    std::size_t phase_;
    double largest_;
    History history_;

public:
    /// The domain is periodic in z.
    static EntryList entries();
    ColumnGrowth(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Measurement operator()(const ParticleView&);
    std::vector<std::vector<double>*> lists() { return history_.lists(); }
};

}
