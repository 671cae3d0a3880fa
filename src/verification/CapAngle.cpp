#include "verification/CapAngle.hpp"
#include "base/CaseError.hpp"
#include "geometry/forEachFoot.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/sharedEntries.hpp"
#include "verification/wallAngle.hpp"
#include <cmath>
#include <limits>
#include <numbers>

namespace sph
{

namespace entry
{
const Choice moment{"by",
                    {{"height", "of the centre of mass"}, {"width", "mean square distance from the axis"}},
                    required,
                    "the moment that gives the angle"};
const Scalar parts{"parts", units::none, 1, positive, "drops over what the scene has of one: 4 of a quarter between planes of symmetry"};
const VectorParameter capOrigin{"origin", units::m, Vector<3>{}, "on the axis, at the wall or above it"};
}

namespace
{
using std::numbers::pi;

constexpr double degree = pi / 180;

/// Volume of the cap of a ball of radius 1 as far as the polar angle x.
double capOfUnitBall(double x) { return pi * (2 + std::cos(x)) * sqr(1 - std::cos(x)) / 3; }

/// The part of a ball that lies above a plane, or outside of a sphere of radius R around the origin.
struct Cap
{
    double solid;                                 ///< R [m]; 0: the plane
    double r = 0, z = 0;                          ///< radius and height of the centre of the ball [m]
    double volume = 0, ofHeight = 0, ofWidth = 0; ///< int dV, int s dV, int d^2 dV with d the distance from the axis

    Cap(double solidRadius, double theta, double ofVolume) : solid(solidRadius)
    {
        if (solid == 0)
        {
            r = std::cbrt(ofVolume / capOfUnitBall(theta));
            z = -r * std::cos(theta);
        }
        else
        {
            double low = 1e-3, high = pi - theta - 1e-6, b = low;
            for (int k = 0; k < 60; ++k)
            {
                b = (low + high) / 2;
                r = solid * std::sin(b) / std::sin(b + theta);
                (std::pow(r, 3) * capOfUnitBall(b + theta) - std::pow(solid, 3) * capOfUnitBall(b) < ofVolume ? low : high) = b;
            }
            z = solid * std::cos(b) - r * std::cos(b + theta);
        }
        // Simpson's rule over the height.
        const double bottom = solid == 0 ? std::max(0.0, z - r) : z - r;
        constexpr int n = 2000;
        const double step = (z + r - bottom) / n;
        for (int k = 0; k <= n; ++k)
        {
            const double s = bottom + k * step, weight = (k == 0 || k == n ? 1 : k % 2 ? 4 : 2) * step / 3;
            const double outer = std::max(0.0, sqr(r) - sqr(s - z)), inner = std::max(0.0, sqr(solid) - sqr(s));
            if (outer <= inner) continue;
            volume += weight * pi * (outer - inner);
            ofHeight += weight * pi * (outer - inner) * s;
            ofWidth += weight * pi * (sqr(outer) - sqr(inner)) / 2;
        }
    }
};

struct Moments
{
    double mass = 0, height = 0, width = 0;
    std::size_t particles = 0;
    Moments& operator+=(const Moments& other)
    {
        mass += other.mass;
        height += other.height;
        width += other.width;
        particles += other.particles;
        return *this;
    }
};

}

CapAngle::CapAngle(const Dictionary& d, const Geometry& geometry, const std::vector<std::string>& phases)
    : phase_(readPhase(d, entry::phase, phases)),
      origin_(entry::capOrigin(d)),
      parts_(entry::parts(d)),
      angle_(entry::angle(d, -1)),
      byHeight_(entry::moment(d) == "height"),
      where_(entry::capOrigin.where(d))
{
    if (geometry.dimension == 2) d.error("name", "the drop is a part of a ball: the scene must have three dimensions");
    if (phases.size() > 1)
    {
        name_ = phases[phase_];
        around_ = phases[phase_ == 0 ? 1 : 0];
    }
}

EntryList CapAngle::entries() { return {entry::phase, entry::moment, entry::capOrigin, entry::parts, entry::angle}; }

Measurement CapAngle::operator()(const ParticleView& view) const
{
    Measurement result;
    result.value = std::numeric_limits<double>::quiet_NaN();
    const auto [foot, patch] = nearestFoot(*view.geometry, origin_);
    if (patch < 0) throw CaseError(where_, "there is no wall on which a drop could lie");
    if (foot.k1 != foot.k2 || foot.k1 > 0 || !foot.smooth)
        throw CaseError(where_, "the drop is known on a plane and outside of a sphere; the wall nearest to `origin` is neither there");
    result.reference = angle_ >= 0 ? angle_
                                   : wallAngle(view.geometry->walls.at(std::size_t(view.geometry->patches[std::size_t(patch)].wall)),
                                               phase_, name_, around_);

    const double solid = foot.k1 < 0 ? -1 / foot.k1 : 0;
    const auto middle = origin_ - (foot.distance + solid) * foot.normal;
    const auto moments = sum(view.n,
                             [&](std::size_t i)
                             {
                                 if (phaseOf(view, i) != phase_) return Moments{};
                                 const auto way = position(view, i) - middle;
                                 const double m = view.mass[i], height = dot(way, foot.normal);
                                 return Moments{m, m * height, m * (dot(way, way) - sqr(height)), 1};
                             });
    result.particles = moments.particles;
    if (moments.particles == 0)
    {
        result.note = "the drop has no particles";
        return result;
    }
    const double volume = parts_ * moments.mass / view.restDensity[phase_];
    const double wanted = (byHeight_ ? moments.height : moments.width) / moments.mass;
    // The higher the centre of mass and the smaller the width, the larger the angle.
    double low = 5 * degree, high = 175 * degree;
    for (int k = 0; k < 40; ++k)
    {
        const double theta = (low + high) / 2;
        const Cap cap(solid, theta, volume);
        const bool isTooSmall = byHeight_ ? cap.ofHeight / cap.volume < wanted : cap.ofWidth / cap.volume > wanted;
        (isTooSmall ? low : high) = theta;
    }
    result.value = (low + high) / 2 / degree;
    if (result.value < 5.01 || result.value > 174.99) result.note = "the drop is no cap of an angle between 5 and 175 degrees";
    return result;
}

}
