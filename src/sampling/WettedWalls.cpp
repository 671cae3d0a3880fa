#include "sampling/WettedWalls.hpp"
#include "parallel/reduce.hpp"
#include "sampling/Interpolator.hpp"
#include "sampling/SampledField.hpp"
#include <algorithm>
#include <array>

namespace sph
{

namespace
{

/// Share of a triangle's area on which a function that is linear over it, with these values in the corners, is positive.
double positiveShare(std::array<double, 3> values)
{
    std::sort(values.begin(), values.end());
    const auto [low, mid, high] = values;
    if (low > 0) return 1;
    if (!(high > 0)) return 0;
    return mid > 0 ? 1 - low * low / ((mid - low) * (high - low)) : high * high / ((high - low) * (high - mid));
}

}

WettedWalls::WettedWalls(const ParticleView& view, const Box& region) : triangles_(view, region) {}

std::vector<WettedWall> WettedWalls::operator()(const ParticleView& view, std::size_t liquid)
{
    const auto& geometry = *view.geometry;
    triangles_.follow(geometry);
    std::vector<double> isLiquid(view.n);
    for (std::size_t i = 0; i < view.n; ++i) isLiquid[i] = phaseOf(view, i) == liquid;

    const Interpolator interpolator(view);
    std::vector<WettedWall> wetted;
    for (auto& wall : triangles_.walls())
    {
        const auto& s = wall.surface;
        std::vector<double> above(s.points.size()); // C - 1/2
#pragma omp parallel for schedule(dynamic, 64)
        for (std::size_t p = 0; p < s.points.size(); ++p)
        {
            const auto weights = interpolator.weights(triangles_.inScene(s.points[p]));
            double C = weights.empty() ? 0 : weights(isLiquid.data());
            if (C > 0) C *= triangles_.filled(wall, p, weights.coverage, geometry);
            above[p] = C - 0.5;
        }
        wetted.push_back(
            sum(s.triangles.size(),
                [&](std::size_t f)
                {
                    const auto& [a, b, c] = s.triangles[f];
                    const double area = wall.areas[f];
                    if (!(area > 0)) return WettedWall{};
                    return WettedWall{area, area * positiveShare({above[std::size_t(a)], above[std::size_t(b)], above[std::size_t(c)]})};
                }));
    }
    return wetted;
}

}
