#include "mapping/Surroundings.hpp"
#include "sampling/SampledField.hpp"
#include <cmath>

namespace sph
{

namespace
{
/// Distance in spacings below which a point is the place of a particle.
constexpr double samePlace = 1e-6;
/// Sum of the sizes of linear weights above which Shepard's take their place. It is 1.0 to 1.1 within the fluid and up to 1.8 half a spacing beyond the last
/// particles at a plane wall.
constexpr double mostAmplified = 2;

double amplification(const PointWeights& weights)
{
    double sum = 0;
    for (const double w : weights.weight) sum += std::fabs(w);
    return sum;
}
}

Surroundings::Surroundings(const ParticleView& view, const Geometry& walls)
    : view_(view), sight_(walls, view.spacing), toWall_(view.n, Box::infinity)
{
    if (walls.patches.empty()) return;
#pragma omp parallel for schedule(dynamic, 256)
    for (std::size_t j = 0; j < view_.n; ++j) toWall_[j] = sight_.toWall(position(view_, j));
}

const Interpolator& Surroundings::reach(int k) const
{
    auto& reach = reaches_[std::size_t(k)];
    std::call_once(reach.isMade,
                   [&]
                   {
                       auto view = view_;
                       view.support *= std::pow(2, k);
                       reach.interpolator = std::make_unique<Interpolator>(view);
                   });
    return *reach.interpolator;
}

Surrounded Surroundings::around(const PlacedPoint& point, Interpolation form, const Admits& admits, int supports) const
{
    Surrounded result;
    std::size_t nearest = 0;
    const auto counts = [&](std::size_t j, const Vector<3>& offset)
    {
        if ((admits && !admits(j)) || !sight_.isFree(point, {point.x + offset, toWall_[j]})) return false;
        if (const double r = mag(offset); r < result.nearest)
        {
            result.nearest = r;
            nearest = j;
        }
        return true;
    };
    for (int k = 0; (1 << k) <= supports; ++k)
    {
        result.nearest = Box::infinity;
        const auto& interpolator = reach(k);
        result.weights = interpolator.weights(point.x, form, counts);
        if (result.weights.empty()) continue;
        result.bySupport = k == 0;
        if (!result.bySupport || result.nearest < samePlace * view_.spacing) result.weights = {{nearest}, {1}, result.weights.coverage};
        else if (form == Interpolation::linear && amplification(result.weights) > mostAmplified)
            result.weights = interpolator.weights(point.x, Interpolation::shepard, counts);
        return result;
    }
    return result;
}

}
