#include "verification/Drop.hpp"
#include "parallel/reduce.hpp"
#include "sampling/SampledField.hpp"
#include "sampling/VolumeMean.hpp"
#include <numbers>

namespace sph
{

namespace
{
constexpr double Vector<3>::*axes[]{&Vector<3>::x, &Vector<3>::y, &Vector<3>::z};

struct Positions
{
    VolumeMean<Vector<3>> x;
    Vector<3> sine, cosine; ///< sum V sin, sum V cos of the angles round the periods
    Positions& operator+=(const Positions& other)
    {
        x += other.x;
        sine += other.sine;
        cosine += other.cosine;
        return *this;
    }
};
}

Drop::Drop(const ParticleView& view, std::size_t phase_, bool ofOthers_) : phase(phase_), ofOthers(ofOthers_)
{
    // The mean of positions in a periodic direction depends on where the domain begins; the mean of angles on a circle does not.
    // It only serves to unfold the drop: the mean of displacements from it is the centre of volume.
    const auto* geometry = view.geometry;
    const auto isPeriodic = [&](int k) { return geometry && geometry->periodic[k]; };
    const auto period = [&](int k) { return geometry->high.*axes[k] - geometry->low.*axes[k]; };
    const auto mean = sum(view.n,
                          [&](std::size_t i)
                          {
                              if (!has(view, i)) return Positions{};
                              const auto x = position(view, i);
                              Vector<3> sine, cosine;
                              for (int k = 0; k < view.dimension; ++k)
                                  if (isPeriodic(k))
                                  {
                                      const double angle = 2 * std::numbers::pi * (x.*axes[k] - geometry->low.*axes[k]) / period(k);
                                      sine.*axes[k] = view.volume[i] * std::sin(angle);
                                      cosine.*axes[k] = view.volume[i] * std::cos(angle);
                                  }
                              return Positions{VolumeMean<Vector<3>>::of(view.volume[i], x), sine, cosine};
                          });
    particles = mean.x.particles;
    volume = mean.x.volume;
    if (particles == 0) return;
    auto within = mean.x.value();
    for (int k = 0; k < view.dimension; ++k)
        if (isPeriodic(k))
        {
            const double turn = std::atan2(mean.sine.*axes[k], mean.cosine.*axes[k]) / (2 * std::numbers::pi);
            within.*axes[k] = geometry->low.*axes[k] + period(k) * (turn - std::floor(turn));
        }
    centre = within + sum(view.n,
                          [&](std::size_t i)
                          {
                              if (!has(view, i)) return Vector<3>{};
                              return view.volume[i] / volume * displacement(view, within, position(view, i));
                          });
}

bool Drop::has(const ParticleView& view, std::size_t i) const { return (phaseOf(view, i) == phase) != ofOthers; }

double Drop::radius(int dimension) const
{
    return dimension == 2 ? std::sqrt(volume / std::numbers::pi) : std::cbrt(3 * volume / (4 * std::numbers::pi));
}

double Drop::reach(const ParticleView& view) const
{
    return reduce(
        view.n, 0.0, [&](std::size_t i) { return has(view, i) ? mag(displacement(view, centre, position(view, i))) : 0.0; }, Larger{});
}

Drop dropOrBubble(const ParticleView& view, std::size_t phase)
{
    const Drop drop(view, phase), rest(view, phase, true);
    return rest.radius(view.dimension) > view.support && rest.reach(view) < drop.reach(view) ? rest : drop;
}

Vector<3> displacement(const ParticleView& view, const Vector<3>& a, const Vector<3>& b)
{
    return view.geometry ? view.geometry->shortest(b - a) : b - a;
}

double domainVolume(const Geometry& geometry)
{
    const auto size = geometry.high - geometry.low;
    return size.x * size.y * (geometry.dimension == 3 ? size.z : 1);
}

}
