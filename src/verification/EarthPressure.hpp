/// Measures: stresses of a layer of soil at rest.
#pragma once
#include "base/SymmTensor.hpp"
#include "sampling/Measurement.hpp"
#include <functional>

namespace sph
{

/// A layer of soil under its own weight, but for a tenth of its height at the base and the surface, where the kernel is not whole or sides are free.
class SoilLayer
{
    Vector<3> g_;
    Location where_;

protected:
    /// Value from a particle's stress, its vertical stress, compression positive, and rho g times its depth [Pa].
    using Value = std::function<double(SymmTensor<3>, double vertical, double weight)>;
    Measurement compare(const ParticleView&, double reference, const Value&) const;

public:
    static EntryList entries();
    explicit SoilLayer(const Dictionary&);
};

/// K = lateral over vertical stress, the lateral stress that of the plane in 2-D and the mean of both in 3-D.
class EarthPressure : public SoilLayer
{
    double K_;

public:
    static EntryList entries();
    EarthPressure(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
    Measurement operator()(const ParticleView&) const;
};

/// Vertical stress over rho g times the depth below the surface, for 1: rho [kg/m^3] present density.
class Overburden : public SoilLayer
{
public:
    Overburden(const Dictionary& d, const Geometry&, const std::vector<std::string>&) : SoilLayer(d) {}
    Measurement operator()(const ParticleView&) const;
};

}
