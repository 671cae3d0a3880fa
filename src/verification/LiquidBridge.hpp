/// Measures: neck, pressure and force of a liquid bridge.
#pragma once
#include "base/CaseError.hpp"
#include "geometry/Geometry.hpp"
#include "sampling/Measurement.hpp"
#include "verification/CapillaryBridge.hpp"

namespace sph
{

/// A liquid bridge between two equal spheres, cylinders in 2-D, against its shape at rest without gravity (CapillaryBridge.hpp). The
/// reference is that of the volume of the phase's particles, sum_i m_i/rho_0, and the scene's surface tension. Of a part of a bridge, and of a liquid without its gas, it is the reference alone that is known.
class LiquidBridge
{
protected:
    std::size_t phase_;
    Vector<3> middle_, axis_;         ///< midway between the centres; along the line of centres, of unit length
    double radius_, gap_ = 0, angle_; ///< [m], [m], [degrees]
    double parts_;
    Location where_;

    /// CaseError where there is no surface tension, or no such bridge.
    CapillaryBridge atRest(const ParticleView&) const;

public:
    /// The bridge lies inside the domain and not across a periodic face.
    static EntryList entries();
    LiquidBridge(const Dictionary&, const Geometry&, const std::vector<std::string>& phases);
};

/// Radius of the neck [m], in 2-D half its width: the mean distance from the line of centres, in the plane midway, at which the volume
/// fraction falls to 1/2.
struct BridgeNeck : LiquidBridge
{
    using LiquidBridge::LiquidBridge;
    explicit BridgeNeck(const LiquidBridge& of) : LiquidBridge(of) {}
    Measurement operator()(const ParticleView&) const;
};

/// Pressure in the bridge minus that of the gas [Pa]: means, weighted with volume, over the particles that see neither the other phase nor
/// a wall within the kernel's support, where the pressure of a diffuse interface, and of a wall that attracts, has no meaning.
struct BridgePressure : LiquidBridge
{
    using LiquidBridge::LiquidBridge;
    explicit BridgePressure(const LiquidBridge& of) : LiquidBridge(of) {}
    Measurement operator()(const ParticleView&) const;
};

/// Attraction of the solids [N], in 2-D [N/m], by the tension and the pressure in the neck: 2 pi r gamma - pi r^2 (p_l - p_g), in 2-D 2 gamma - 2 r (p_l - p_g).
struct BridgeForce : LiquidBridge
{
    using LiquidBridge::LiquidBridge;
    Measurement operator()(const ParticleView&) const;
};

}
