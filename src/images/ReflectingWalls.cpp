#include "images/ReflectingWalls.hpp"
#include <cmath>
#include <numbers>

namespace sph
{

namespace
{
Reflector reflectorOf(const Patch& patch)
{
    if (patch.mesh) return {Reflector::Kind::mesh};
    if (std::isfinite(patch.shape->smallestRadius()) || patch.shape->hasEdges()) return {Reflector::Kind::body};
    return {Reflector::Kind::plane, patch.shape->foot({}).normal};
}
}

ReflectingWalls::ReflectingWalls(const Geometry& geometry, double reach, double spacing, double skin, double further)
    : geometry_(&geometry), near_(geometry, std::max(reach, further)), reach_(reach), spacing_(spacing), skin_(skin)
{
    std::ranges::transform(geometry.patches, std::back_inserter(reflectors_), reflectorOf);
}

bool ReflectingWalls::fillsCorner(int p, int q, const Vector<3>& x) const
{
    if (!geometry_->mayBeCovered(p) || !std::ranges::binary_search(geometry_->coverers[std::size_t(p)], q)) return true;
    return geometry_->patches[std::size_t(p)].shape->foot(x).distance <= geometry_->tolerance() || geometry_->isCovered(p, x);
}

double ReflectingWalls::speedOf(const Foot& f) const
{
    const double k = std::max({f.k1, f.k2, 0.0}), d = std::max(f.distance, std::min(f.distance + 0.5 * skin_, reach_ - skin_));
    return k > 0 && f.distance <= reach_ - skin_ ? (1 + k * d) / std::max(1 - k * d, 0.01) : 1;
}

double ReflectingWalls::turnOf(int patch, const Foot& f, double speed) const
{
    const auto& shape = *geometry_->patches[std::size_t(patch)].shape;
    if (meshOf(patch) || shape.hasEdges()) return std::numbers::pi;
    const double concave = std::max({f.k1, f.k2, 0.0});
    return 0.5 * skin_ * speed / (shape.smallestRadius() * std::max(1 - concave * f.distance, 0.01));
}

}
