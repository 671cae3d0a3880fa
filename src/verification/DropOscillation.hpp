/// Measures: period and decay rate of an oscillating drop.
#pragma once
#include "sampling/History.hpp"
#include "sampling/Measurement.hpp"
#include <complex>
#include <optional>

namespace sph
{

/// A drop that oscillates in mode 2, r = R + a cos(2 theta), in 3-D r = R + a P_2(z/r), against the exact root of the linear problem of two
/// viscous fluids (DropMode.hpp). The amplitude is that of the second moments of the drop about its centre,
///
///   a/R = (I_xx - I_yy)/(V R^2),   in 3-D 5/3 (I_zz - (I_xx + I_yy)/2)/(V R^2),   I_xx = sum_i m_i/rho_0 x_i^2,   V = sum_i m_i/rho_0
///
/// which changes smoothly as particles move and needs no surface. Each sample adds to the fit (ModeFit.hpp) of those since `from`. With
/// `centre` a half, a quarter or an eighth of a drop, cut by planes of symmetry, has the amplitude of the whole.
class DropOscillation
{
    std::size_t phase_;
    double radius_;                   ///< [m]; 0: from the volume of the drop's particles
    std::optional<Vector<3>> centre_; ///< [m]; none: that of the drop's particles
    History history_;

public:
    struct Rates
    {
        std::complex<double> found, exact; ///< [1/s]; found is NaN as long as it cannot be fitted
        Measurement measurement;           ///< without value and reference
    };

    static EntryList entries();
    DropOscillation(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Rates operator()(const ParticleView&);
    std::vector<std::vector<double>*> lists() { return history_.lists(); }
};

/// 2 pi/Im s [s]
struct DropPeriod
{
    DropOscillation drop;
    static EntryList entries() { return DropOscillation::entries(); }
    DropPeriod(const Dictionary& d, const Geometry& g, const std::vector<std::string>& phases) : drop(d, g, phases) {}
    Measurement operator()(const ParticleView&);
    std::vector<std::vector<double>*> lists() { return drop.lists(); }
};

/// -Re s [1/s]
struct DropDecay
{
    DropOscillation drop;
    static EntryList entries() { return DropOscillation::entries(); }
    DropDecay(const Dictionary& d, const Geometry& g, const std::vector<std::string>& phases) : drop(d, g, phases) {}
    Measurement operator()(const ParticleView&);
    std::vector<std::vector<double>*> lists() { return drop.lists(); }
};

}
