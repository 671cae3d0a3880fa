#include "verification/ContactAngle.hpp"
#include "geometry/forEachFoot.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/SphereFit.hpp"
#include "sampling/sharedEntries.hpp"
#include "verification/Drop.hpp"
#include "verification/VolumeFraction.hpp"
#include "verification/wallAngle.hpp"
#include <algorithm>
#include <limits>
#include <numbers>

namespace sph
{

namespace entry
{
const Scalar above{"above", Unit{units::none, "spacings"}, 2.5, nonNegative, "height above the wall from which on the surface is fitted"};
}

namespace
{

using std::numbers::pi;

/// Evenly spread over the circle, or over the sphere by the golden angle.
std::vector<Vector<3>> directions(int dimension)
{
    const int n = dimension == 2 ? 360 : 1000;
    std::vector<Vector<3>> result;
    for (int k = 0; k < n; ++k)
        if (dimension == 2) result.push_back({std::cos(2 * pi * (k + 0.5) / n), std::sin(2 * pi * (k + 0.5) / n), 0});
        else
        {
            const double y = 1 - 2 * (k + 0.5) / n, r = std::sqrt(1 - y * y), angle = k * pi * (3 - std::sqrt(5.0));
            result.push_back({r * std::cos(angle), y, r * std::sin(angle)});
        }
    return result;
}

}

ContactAngle::ContactAngle(const Dictionary& d, const Geometry&, const std::vector<std::string>& phases)
    : phase_(readPhase(d, entry::phase, phases)), angle_(entry::angle(d, -1)), above_(entry::above(d))
{
    if (phases.size() > 2 && angle_ < 0)
        entry::angle.error(d, "is needed where there are more than two phases: the angle through a drop depends on what lies around it");
    if (phases.size() < 2) return;
    name_ = phases[phase_];
    around_ = phases[phase_ == 0 ? 1 : 0];
}

EntryList ContactAngle::entries() { return {entry::phase, entry::angle, entry::above}; }

Measurement ContactAngle::operator()(const ParticleView& view) const
{
    constexpr double degree = std::numbers::pi / 180;
    Measurement result;
    result.value = std::numeric_limits<double>::quiet_NaN();
    const Drop drop(view, phase_);
    result.particles = drop.particles;

    const auto& patches = view.geometry->patches;
    const auto [foot, patch] = nearestFoot(*view.geometry, drop.centre);
    if (patch < 0 || drop.particles == 0)
    {
        result.note = patches.empty()       ? "there is no wall"
                      : drop.particles == 0 ? "the drop has no particles"
                                            : "a particle of the drop has no position";
        return result;
    }
    const auto& shape = *patches[std::size_t(patch)].shape;
    if (view.dimension == 3 && foot.k1 != foot.k2)
    {
        result.note = "on a wall that is not equally curved all around a drop is no part of a sphere";
        return result;
    }
    const auto& wall = view.geometry->walls.at(std::size_t(patches[std::size_t(patch)].wall));
    result.reference = angle_ >= 0 ? angle_ : wallAngle(wall, phase_, name_, around_);

    const double farthest = most(view.n, [&](std::size_t i)
                                 { return phaseOf(view, i) == phase_ ? mag(displacement(view, drop.centre, position(view, i))) : 0; });

    // A cap is convex: each ray from its centre of volume leaves it once. The last point inside the fluid of a ray towards the
    // wall is no point of the surface.
    std::vector<Vector<3>> surface;
    const VolumeFraction fraction(view, phase_);
    for (const auto& direction : directions(view.dimension))
    {
        const double sinks = -dot(direction, foot.normal), beyond = farthest + view.support;
        const double reach = sinks * beyond > foot.distance ? foot.distance / sinks : beyond;
        const auto r = fraction.surface(drop.centre, direction, reach);
        if (r && shape.foot(drop.centre + *r * direction).distance > above_ * view.spacing) surface.push_back(drop.centre + *r * direction);
    }

    const auto sphere = fitSphere(surface, view.dimension);
    if (sphere.radius > 0)
    {
        const double h = shape.foot(sphere.centre).distance, R = sphere.radius;
        result.value = std::acos(std::clamp(-h / R - foot.k1 * (sqr(R) - sqr(h)) / (2 * R), -1.0, 1.0)) / degree;
    }
    else result.note = "the surface of the drop does not rise far enough above the wall to be fitted";
    return result;
}

}
