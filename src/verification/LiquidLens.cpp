#include "verification/LiquidLens.hpp"
#include "sampling/SphereFit.hpp"
#include "sampling/sharedEntries.hpp"
#include "sampling/surfaceTensionOf.hpp"
#include "verification/Drop.hpp"
#include "verification/VolumeFraction.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>

namespace sph
{

namespace entry
{
const Word towards{"towards", required, "phase on the side of the lens that is measured"};
const Scalar clear{"clear", units::none, 0.01, positiveBelow(1),
                   "fraction of the third phase above which a place on the surface is not fitted"};
}

namespace
{
using std::numbers::pi;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Evenly spread over the circle, or over the sphere by the golden angle.
Vector<3> direction(int dimension, int k, int n)
{
    if (dimension == 2) return {std::cos(2 * pi * (k + 0.5) / n), std::sin(2 * pi * (k + 0.5) / n), 0};
    const double y = 1 - 2 * (k + 0.5) / n, r = std::sqrt(1 - y * y), angle = k * pi * (3 - std::sqrt(5.0));
    return {r * std::cos(angle), y, r * std::sin(angle)};
}

Vector<3> mean(const std::vector<Vector<3>>& points)
{
    Vector<3> sum;
    for (const auto& x : points) sum += x;
    return 1.0 / double(points.size()) * sum;
}

/// V/a^dimension of a cap that meets its base at theta.
double capVolume(int dimension, double theta)
{
    const double c = std::cos(theta), s = std::sin(theta);
    return dimension == 2 ? (theta - s * c) / (s * s) : pi * (2 - 3 * c + c * c * c) / (3 * s * s * s);
}
}

LiquidLens::LiquidLens(const Dictionary& d, const Geometry&, const std::vector<std::string>& phases)
    : phase_(readPhase(d, entry::phase, phases)), clear_(entry::clear(d))
{
    if (phases.size() != 3)
        entry::phase.error(d, fmt::format("a lens is one phase of three, and constant/phaseProperties has {}", phases.size()));
    std::size_t found = 0;
    for (std::size_t k = 0; k < phases.size() && found < 2; ++k)
        if (k != phase_) around_[found++] = k;
}

LiquidLens::Shape LiquidLens::fitted(const ParticleView& view) const
{
    Shape shape;
    const Drop drop(view, phase_);
    shape.particles = drop.particles;
    if (drop.particles == 0)
    {
        shape.note = "the lens has no particles";
        return shape;
    }
    const double reach = 0.5 * std::max(view.geometry->length(0), view.geometry->length(1));
    const VolumeFraction lens(view, phase_), first(view, around_[0]), second(view, around_[1]);
    std::array<std::vector<Vector<3>>, 2> surface;
    const int n = view.dimension == 2 ? 360 : 2000;
    for (int k = 0; k < n; ++k)
    {
        const auto along = direction(view.dimension, k, n);
        const auto r = lens.surface(drop.centre, along, reach);
        if (!r) continue;
        const auto x = drop.centre + *r * along;
        const double a = first(x), b = second(x);
        if (std::min(a, b) < clear_) surface[a > b ? 0 : 1].push_back(x);
    }
    for (const auto& side : surface)
        if (side.size() < 10) shape.note = "the lens has no surface on one of its sides that is clear of the third phase";
    if (!shape.note.empty()) return shape;

    // Seen from its cap each centre lies behind the chord, by h = R cos(theta), and both h^2 + a^2 = R^2.
    const auto lower = fitSphere(surface[0], view.dimension), upper = fitSphere(surface[1], view.dimension);
    const auto up = mean(surface[1]) - mean(surface[0]);
    const double D = dot(lower.centre - upper.centre, 1 / mag(up) * up), R1 = lower.radius, R2 = upper.radius;
    const double h1 = (D * D + R1 * R1 - R2 * R2) / (2 * D), h2 = D - h1, half = R1 * R1 - h1 * h1;
    if (!(R1 > 0 && R2 > 0 && half > 0))
    {
        shape.note = "the circles fitted to the two sides of the lens do not meet";
        return shape;
    }
    shape.a = std::sqrt(half);
    shape.angle = {std::acos(std::clamp(h1 / R1, -1.0, 1.0)) * 180 / pi, std::acos(std::clamp(h2 / R2, -1.0, 1.0)) * 180 / pi};
    return shape;
}

LiquidLens::Shape LiquidLens::exact(const ParticleView& view) const
{
    Shape shape;
    const auto gamma = [&](std::size_t a, std::size_t b) { return surfaceTensionOf(view, a, b); };
    const double plane = gamma(around_[0], around_[1]), one = gamma(phase_, around_[0]), two = gamma(phase_, around_[1]);
    const auto angle = [&](double own, double other) { return std::acos((plane * plane + own * own - other * other) / (2 * plane * own)); };
    const double theta1 = angle(one, two), theta2 = angle(two, one);
    shape.angle = {theta1 * 180 / pi, theta2 * 180 / pi};
    const double volume = capVolume(view.dimension, theta1) + capVolume(view.dimension, theta2);
    shape.a = std::pow(Drop(view, phase_).volume / volume, 1.0 / view.dimension);
    if (!std::isfinite(shape.a)) shape.note = "the three surface tensions make no triangle: there is no lens at rest";
    return shape;
}

LensAngle::LensAngle(const Dictionary& d, const Geometry& g, const std::vector<std::string>& phases) : LiquidLens(d, g, phases), side_(0)
{
    const auto towards = readPhase(d, entry::towards, phases);
    if (towards == phase_) entry::towards.error(d, "is a phase beside the lens, not the lens itself");
    side_ = towards == around_[1] ? 1 : 0;
}

EntryList LensAngle::entries() { return {entry::phase, entry::towards, entry::clear}; }
EntryList LensRadius::entries() { return {entry::phase, entry::clear}; }

Measurement LensAngle::operator()(const ParticleView& view) const
{
    const auto now = fitted(view), rest = exact(view);
    return {now.note.empty() ? now.angle[side_] : nan, rest.angle[side_], now.particles, now.note.empty() ? rest.note : now.note};
}

Measurement LensRadius::operator()(const ParticleView& view) const
{
    const auto now = fitted(view), rest = exact(view);
    return {now.note.empty() ? now.a : nan, rest.a, now.particles, now.note.empty() ? rest.note : now.note};
}

}
