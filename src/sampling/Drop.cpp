#include "Drop.hpp"
#include "SampledField.hpp"
#include <numbers>

namespace sph
{

namespace
{
constexpr double Vector<3>::*axes[]{&Vector<3>::x, &Vector<3>::y, &Vector<3>::z};
}

Drop::Drop(const ParticleView& view, std::size_t ofPhase) : phase(ofPhase)
{
    // In a periodic direction the mean of positions depends on where the domain begins; the mean of angles on a circle does not.
    // It only serves to unfold the drop: the mean of displacements from it is the centre of volume.
    Vector<3> sine, cosine, first;
    const auto* geometry = view.geometry;
    const auto angle = [&](int k, double x)
    { return 2 * std::numbers::pi * (x - geometry->low.*axes[k]) / (geometry->high.*axes[k] - geometry->low.*axes[k]); };
    for (std::size_t i = 0; i < view.n; ++i)
    {
        if (phaseOf(view, i) != phase) continue;
        const auto x = position(view, i);
        if (particles++ == 0) first = x;
        volume += view.volume[i];
        if (geometry)
            for (int k = 0; k < view.dimension; ++k)
                if (geometry->periodic[k])
                {
                    sine.*axes[k] += view.volume[i] * std::sin(angle(k, x.*axes[k]));
                    cosine.*axes[k] += view.volume[i] * std::cos(angle(k, x.*axes[k]));
                }
    }
    if (particles == 0) return;
    centre = first;
    if (geometry)
        for (int k = 0; k < view.dimension; ++k)
            if (geometry->periodic[k])
            {
                const double period = geometry->high.*axes[k] - geometry->low.*axes[k];
                const double turn = std::atan2(sine.*axes[k], cosine.*axes[k]) / (2 * std::numbers::pi);
                centre.*axes[k] = geometry->low.*axes[k] + period * (turn - std::floor(turn));
            }
    Vector<3> mean;
    for (std::size_t i = 0; i < view.n; ++i)
        if (phaseOf(view, i) == phase) mean += view.volume[i] / volume * displacement(view, centre, position(view, i));
    centre += mean;
}

Vector<3> displacement(const ParticleView& view, const Vector<3>& a, const Vector<3>& b)
{
    auto d = b - a;
    if (view.geometry)
        for (int k = 0; k < view.dimension; ++k)
            if (view.geometry->periodic[k])
            {
                const double period = view.geometry->high.*axes[k] - view.geometry->low.*axes[k];
                d.*axes[k] -= period * std::round(d.*axes[k] / period);
            }
    return d;
}

double domainVolume(const Geometry& geometry)
{
    const auto size = geometry.high - geometry.low;
    return size.x * size.y * (geometry.dimension == 3 ? size.z : 1);
}

}
