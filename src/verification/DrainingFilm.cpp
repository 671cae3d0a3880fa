#include "verification/DrainingFilm.hpp"
#include "base/CaseError.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/sharedEntries.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace sph
{

namespace entry
{
const Scalar cylinderRadius{"radius", units::m, required, positive, "of the cylinder"},
    fromTop{"within", degrees, 45, between(0, 90), "angle from the top to either side within which the film is measured"},
    sides{"parts", units::none, 1, positive, "cylinders over what the scene has of one: 2 of a half beside a plane of symmetry"};
const Direction cylinderAxis{"axis", required, "of the cylinder, one of the coordinate axes"};
}

namespace
{

constexpr std::size_t cells = 120; ///< of the theory, from the top on

/// Volume of the film, and particles in it.
struct Amount
{
    double volume = 0;
    std::size_t particles = 0;
    Amount& operator+=(const Amount& other)
    {
        volume += other.volume;
        particles += other.particles;
        return *this;
    }
};

}

DrainingFilm::DrainingFilm(const Dictionary& d, const Geometry& geometry, const std::vector<std::string>& phases)
    : phase_(readPhase(d, entry::phase, phases)),
      origin_(entry::origin(d)),
      axis_(entry::cylinderAxis(d)),
      radius_(entry::cylinderRadius(d)),
      within_(entry::fromTop(d) * std::numbers::pi / 180),
      parts_(entry::sides(d)),
      where_(entry::cylinderAxis.where(d))
{
    if (geometry.dimension == 2) d.error("name", "the film is measured in three dimensions");
}

EntryList DrainingFilm::entries()
{
    return {entry::phase, entry::origin, entry::cylinderAxis, entry::cylinderRadius, entry::fromTop, entry::sides};
}

double DrainingFilm::flow(double area, double g, double nu) const
{
    const double a = radius_, b = std::sqrt(a * a + 2 * area), thick = b * b - a * a;
    return g * b / nu * (b * b * thick / (8 * a * a) + thick / 8 - b * b / 2 * std::log(b / a));
}

void DrainingFilm::march(double until, double g, double nu)
{
    // A small Courant number: dq/dA is g h^2/(nu a) of a thin film.
    const double width = within_ / cells, thickest = *std::ranges::max_element(areas_) / radius_;
    const double longest = 0.1 * width / (g * sqr(thickest) / (nu * radius_) * std::sin(within_));
    double& now = times_.front();
    while (now < until - 1e-12)
    {
        const double step = std::min(until - now, longest);
        double before = 0;
        for (std::size_t k = 0; k < cells; ++k)
        {
            const double flux = flow(areas_[k], g, nu) * std::sin(double(k + 1) * width);
            areas_[k] -= step / width * (flux - before);
            before = flux;
        }
        now += step;
    }
}

Measurement DrainingFilm::operator()(const ParticleView& view)
{
    const double g = mag(view.gravity), length = std::fabs(dot(view.geometry->high - view.geometry->low, axis_));
    if (!(g > 0)) throw CaseError(where_, "a film drains by gravity, and constant/g gives none");
    const auto up = -view.gravity / g, side = cross(axis_, up);
    const double nu = view.viscosity[phase_] / view.restDensity[phase_];
    const auto amount = sum(view.n,
                            [&](std::size_t i)
                            {
                                const auto way = position(view, i) - origin_;
                                if (phaseOf(view, i) != phase_ || std::atan2(std::fabs(dot(way, side)), dot(way, up)) >= within_)
                                    return Amount{};
                                return Amount{view.mass[i] / view.restDensity[phase_], 1};
                            });
    const auto thickness = [&](double area) { return std::sqrt(radius_ * radius_ + 2 * area) - radius_; };
    const double area = parts_ * amount.volume / (2 * within_ * length);
    if (times_.empty())
    {
        areas_.assign(cells, area);
        times_ = {view.time};
    }
    march(view.time, g, nu);
    double mean = 0;
    for (const double each : areas_) mean += each / cells;
    return {thickness(area), thickness(mean), amount.particles, ""};
}

}
