#include "models/gas/LiquidMap.hpp"
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace sph
{

namespace
{
/// A particle stands no nearer to a wall [spacings].
constexpr double leastFromWall = 0.45;
}

LiquidMap::LiquidMap(const Geometry& geometry, double spacing, SceneEnds ends)
    : LiquidDistance(geometry, spacing), ends_(std::move(ends)), spacing_(spacing)
{
    for (auto* each : {&enclosed_, &wasOpen_, &place_}) each->resize(cells());
    findPlaces();
}

void LiquidMap::findPlaces()
{
    const double least = leastFromWall * spacing_;
#pragma omp parallel for schedule(dynamic, 1024)
    for (std::size_t c = 0; c < cells(); ++c)
    {
        const double d = geometry_.distance(centre(c));
        const auto [plane, s] = ends_.nearest ? ends_.nearest(centre(c)) : std::pair<const OpenPlane*, double>{nullptr, Box::infinity};
        const bool isHeld = plane && !plane->inlet && -s >= ends_.sight && -s < ends_.depth && d >= least;
        place_[c] = d < 0 ? solid : std::min(d, s) >= least ? room : isHeld ? heldUnseen : besideWall;
    }
}

std::size_t LiquidMap::blockOf(std::size_t cell, int cells) const
{
    const auto at = indices(cell);
    std::size_t block = 0;
    for (int k = 2; k >= 0; --k) block = block * std::size_t(n_[std::size_t(k)] / cells + 1) + std::size_t(at[std::size_t(k)] / cells);
    return block;
}

void LiquidMap::measure(double reach)
{
    LiquidDistance::measure(reach);
    findEnclosed();
}

/// Cells that share a face are joined, each with those before it along every direction, as trees whose roots are regions.
void LiquidMap::findEnclosed()
{
    regions_.reset(cells(), [&](std::size_t c) { return squaredDistance(c) > 1 && place_[c] != solid; });
    std::size_t stride = 1;
    for (std::size_t k = 0; k < std::size_t(geometry_.dimension); ++k)
    {
        const std::size_t n = std::size_t(n_[k]), whole = stride * n;
        for (std::size_t begin = 0; begin < cells(); begin += whole)
        {
            for (std::size_t c = begin + stride; c < begin + whole; ++c) regions_.join(c - stride, c);
            for (std::size_t c = begin; geometry_.periodic[k] && c < begin + stride; ++c) regions_.join(c, c + whole - stride);
        }
        stride = whole;
    }
    std::map<int, std::size_t> sizes; // by root
    int lastRoot = -1;
    std::size_t* ofLast = nullptr;
    for (std::size_t c = 0; c < cells(); ++c)
    {
        if (!regions_.isIn(c)) continue;
        const int root = regions_.rootOf(c);
        if (root != lastRoot) ofLast = &sizes[lastRoot = root];
        ++*ofLast;
    }
    const auto largest = std::ranges::max_element(sizes, {}, [](const auto& region) { return region.second; });
    pockets_ = std::max(0, int(sizes.size()) - 1);
    for (std::size_t c = 0; c < cells(); ++c)
    {
        wasOpen_[c] = hasMeasured_ && !enclosed_[c];
        enclosed_[c] = regions_.isIn(c) && regions_.rootOf(c) != largest->first;
    }
    hasMeasured_ = true;
}

}
