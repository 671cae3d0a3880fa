#include "ContactAngle.hpp"
#include "Drop.hpp"
#include "Interpolator.hpp"
#include "SampledField.hpp"
#include "SphereFit.hpp"
#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace sph
{

namespace
{

/// Evenly spread over the circle, or over the sphere by the golden angle.
std::vector<Vector<3>> directions(int dimension)
{
    constexpr double pi = std::numbers::pi;
    const int n = dimension == 2 ? 360 : 1000;
    std::vector<Vector<3>> result;
    for (int k = 0; k < n; ++k)
        if (dimension == 2)
            result.push_back({std::cos(2 * pi * (k + 0.5) / n), std::sin(2 * pi * (k + 0.5) / n), 0});
        else
        {
            const double y = 1 - 2 * (k + 0.5) / n, r = std::sqrt(1 - y * y), angle = k * pi * (3 - std::sqrt(5.0));
            result.push_back({r * std::cos(angle), y, r * std::sin(angle)});
        }
    return result;
}

}

ContactAngle::ContactAngle(const Dictionary& d, const Geometry&, const std::vector<std::string>& phases)
    : phase_(readPhase(d, "phase", phases)), angle_(d.get("angle", -1.0)), above_(d.getNonNegative("above", units::none, 2.5))
{
    if (d.found("angle") && !(angle_ >= 0 && angle_ <= 180)) d.error("angle", "a contact angle lies between 0 and 180 degrees");
}

Measurement ContactAngle::operator()(const ParticleView& view) const
{
    constexpr double degree = std::numbers::pi / 180;
    Measurement result;
    result.value = std::numeric_limits<double>::quiet_NaN();
    const Drop drop(view, phase_);
    result.particles = drop.particles;

    const Patch* wall = nullptr;
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& patch : view.geometry->patches)
        if (const double d = patch.shape->foot(drop.centre).distance; d < nearest)
        {
            nearest = d;
            wall = &patch;
        }
    if (!wall || drop.particles == 0)
    {
        result.note = wall ? "the drop has no particles" : "there is no wall";
        return result;
    }
    const auto foot = wall->shape->foot(drop.centre);
    const double ofWall = view.geometry->walls.at(std::size_t(wall->wall)).contactAngle;
    result.reference = angle_ >= 0 ? angle_ : phase_ == 0 ? ofWall : 180 - ofWall;

    const Interpolator interpolator(view);
    const auto fraction = [&](const Vector<3>& x)
    {
        const auto weights = interpolator.weights(x, Interpolation::shepard);
        if (view.phases.size() < 2) return weights.coverage;
        double sum = 0;
        for (std::size_t k = 0; k < weights.particle.size(); ++k)
            if (phaseOf(view, weights.particle[k]) == phase_) sum += weights.weight[k];
        return sum;
    };
    double farthest = 0;
    for (std::size_t i = 0; i < view.n; ++i)
        if (phaseOf(view, i) == phase_) farthest = std::max(farthest, mag(displacement(view, drop.centre, position(view, i))));

    // A cap is convex: each ray from its centre of volume leaves it once. The last point inside the fluid of a ray towards the
    // wall is no point of the surface.
    std::vector<Vector<3>> surface;
    const double step = view.spacing / 2;
    for (const auto& direction : directions(view.dimension))
    {
        const auto at = [&](double r) { return drop.centre + r * direction; };
        const auto height = [&](double r) { return dot(at(r) - drop.centre, foot.normal) + foot.distance; };
        double in = 0, out = step;
        while (out < farthest + view.support && height(out) > 0 && fraction(at(out)) >= 0.5) in = std::exchange(out, out + step);
        if (out >= farthest + view.support || height(out) <= above_ * view.spacing) continue;
        for (int k = 0; k < 20; ++k)
        {
            const double middle = (in + out) / 2;
            (fraction(at(middle)) >= 0.5 ? in : out) = middle;
        }
        if (height(in) > above_ * view.spacing) surface.push_back(at(in));
    }

    const auto sphere = fitSphere(surface, view.dimension);
    if (sphere.radius > 0)
    {
        const double h = dot(sphere.centre - drop.centre, foot.normal) + foot.distance;
        result.value = std::acos(std::clamp(-h / sphere.radius, -1.0, 1.0)) / degree;
    }
    else
        result.note = "the surface of the drop does not rise far enough above the wall to be fitted";
    return result;
}

}
