#include "verification/LiquidBridge.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include "sampling/sharedEntries.hpp"
#include "sampling/surfaceTensionOf.hpp"
#include "verification/VolumeFraction.hpp"
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace sph
{

namespace entry
{
const ListOf<Vector<3>> centres{"centres", units::m, required, "centres of the two solids"};
const Scalar bridgeRadius{"radius", units::m, required, positive, "of the solids"},
    bridgeContactAngle{"contactAngle", degrees, required,
                       Range{.low = 0, .high = 180, .highIncluded = false}.saying(
                           "a liquid forms a bridge where its contact angle lies between 0 and 180 degrees"),
                       "of the solids"},
    bridgeParts{"parts", units::none, 1, positive, "bridges over what the scene has of one: 8 of an eighth between planes of symmetry"};
}

namespace
{

/// Evenly spread round the axis; to either side in 2-D.
std::vector<Vector<3>> directionsAcross(const Vector<3>& axis, int dimension)
{
    if (dimension == 2) return {{-axis.y, axis.x, 0}, {axis.y, -axis.x, 0}};
    const auto other = std::fabs(axis.z) < 0.5 ? Vector<3>{0, 0, 1} : Vector<3>{1, 0, 0};
    const auto first = cross(axis, other) / mag(cross(axis, other)), second = cross(axis, first);
    std::vector<Vector<3>> directions;
    const int n = 32;
    for (int k = 0; k < n; ++k)
    {
        const double angle = 2 * std::numbers::pi * (k + 0.5) / n;
        directions.push_back(std::cos(angle) * first + std::sin(angle) * second);
    }
    return directions;
}

double volumeOf(const ParticleView& view, std::size_t phase)
{
    return sum(view.n, [&](std::size_t i) { return phaseOf(view, i) == phase ? view.mass[i] : 0; }) / view.restDensity[phase];
}

}

LiquidBridge::LiquidBridge(const Dictionary& d, const Geometry& geometry, const std::vector<std::string>& phases)
    : phase_(readPhase(d, entry::phase, phases)),
      radius_(entry::bridgeRadius(d)),
      angle_(entry::bridgeContactAngle(d)),
      parts_(entry::bridgeParts(d)),
      where_(entry::centres.where(d))
{
    if (phases.size() > 2) d.error("name", "the bridge is one of liquid in a gas, or of liquid alone: the scene has more than two phases");
    auto centres = entry::centres(d);
    if (centres.size() != 2)
    {
        if (entry::centres.given(d)) entry::centres.error(d, fmt::format("a bridge has two centres, not {}", centres.size()));
        return;
    }
    if (geometry.dimension == 2) centres[0].z = centres[1].z = 0;
    const double distance = mag(centres[1] - centres[0]);
    gap_ = distance - 2 * radius_;
    if (gap_ < 0)
        entry::centres.error(d, fmt::format("the centres are {:.4g} m apart, less than two radii: there is no gap for a bridge", distance));
    else axis_ = (centres[1] - centres[0]) / distance;
    middle_ = (centres[0] + centres[1]) / 2;
}

EntryList LiquidBridge::entries()
{
    return {entry::phase, entry::centres, entry::bridgeRadius, entry::bridgeContactAngle, entry::bridgeParts};
}

CapillaryBridge LiquidBridge::atRest(const ParticleView& view) const
{
    if (!(surfaceTensionOf(view) > 0)) throw CaseError(where_, "a bridge has surface tension, and constant/phaseProperties gives no sigma");
    try
    {
        return {view.dimension, radius_, gap_, parts_ * volumeOf(view, phase_), angle_};
    }
    catch (const CaseError& e)
    {
        throw CaseError(where_, e.what());
    }
}

Measurement BridgeNeck::operator()(const ParticleView& view) const
{
    Measurement result;
    result.reference = atRest(view).neck();
    const VolumeFraction fraction(view, phase_);
    const double reach = mag(view.geometry->high - view.geometry->low);
    double sum = 0;
    const auto directions = directionsAcross(axis_, view.dimension);
    for (const auto& direction : directions)
        if (const auto r = fraction(middle_) >= 0.5 ? fraction.surface(middle_, direction, reach) : std::nullopt)
        {
            sum += *r;
            ++result.particles;
        }
    result.value = sum / double(result.particles);
    if (result.particles < directions.size())
    {
        result.value = std::numeric_limits<double>::quiet_NaN();
        result.note = "midway between the solids there is no bridge with a surface all round";
    }
    return result;
}

Measurement BridgePressure::operator()(const ParticleView& view) const
{
    Measurement result;
    result.reference = surfaceTensionOf(view) * atRest(view).curvature();
    const VolumeFraction fraction(view, phase_);
    const SampledField p(view, "p", {});
    enum Side : std::size_t
    {
        inside,
        outside,
        neither
    };
    const auto side = [&](std::size_t i)
    {
        const auto x = position(view, i);
        if (view.geometry->distance(x) < view.support) return neither;
        const double ofLiquid = fraction(x), other = 1 - ofLiquid, none = 1e-12;
        return other < none ? inside : ofLiquid < none ? outside : neither;
    };
    const auto mean = groupSums(view.n, neither, side, [&](std::size_t i) { return VolumeMean<>::of(view.volume[i], p(0, i)); });
    result.particles = mean[inside].particles;
    result.value = mean[inside].value() - mean[outside].value();
    if (mean[inside].particles == 0 || mean[outside].particles == 0)
        result.note = fmt::format("no particle of the {} is farther than the kernel's support from both interface and walls",
                                  mean[inside].particles > 0 ? "gas" : "bridge");
    return result;
}

Measurement BridgeForce::operator()(const ParticleView& view) const
{
    const double gamma = surfaceTensionOf(view);
    const auto neck = BridgeNeck(*this)(view), jump = BridgePressure(*this)(view);
    const double r = neck.value;
    return {view.dimension == 3 ? std::numbers::pi * r * (2 * gamma - r * jump.value) : 2 * (gamma - r * jump.value),
            gamma * atRest(view).force(), jump.particles, neck.note.empty() ? jump.note : neck.note};
}

}
