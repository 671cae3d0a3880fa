#include "geometry/PatchGrid.hpp"
#include "geometry/MovingWalls.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <numeric>

namespace sph
{

namespace
{

/// A finer grid costs memory and gains little.
constexpr double mostPatchCells = 1 << 19;

}

PatchGrid::PatchGrid(const Geometry& geometry, double reach) : all_(geometry.patches.size())
{
    std::iota(all_.begin(), all_.end(), 0);
    const int dim = geometry.dimension;
    Vector<3> extent{0, 0, 0}, size{1, 1, 1};
    double volume = 1;
    for (int k = 0; k < dim; ++k)
    {
        const auto c = component(k);
        low_.*c = geometry.low.*c - reach;
        extent.*c = geometry.length(k) + 2 * reach;
        volume *= extent.*c;
    }
    const double edge = std::max(reach, std::pow(volume / mostPatchCells, 1.0 / dim));
    double halfDiagonal = 0;
    for (int k = 0; k < dim; ++k)
    {
        const auto c = component(k);
        cells_[k] = edge > 0 ? std::max(1, int(extent.*c / edge)) : 1;
        size.*c = extent.*c / cells_[k];
        inverseSize_.*c = 1 / size.*c;
        halfDiagonal += sqr(0.5 * size.*c);
    }
    halfDiagonal = std::sqrt(halfDiagonal) * (1 + 1e-12);

    const auto centre = [&](int i, int k, int l) {
        return Vector<3>{low_.x + (i + 0.5) * size.x, low_.y + (k + 0.5) * size.y, dim == 3 ? low_.z + (l + 0.5) * size.z : 0.0};
    };
    // Solids that end touch only the cells around their bounds; the inside of all others may be anywhere.
    const auto range = [&](const Shape& shape, int k) -> std::array<int, 2>
    {
        if (k >= dim || shape.enclosesFluid()) return {0, cells_[k] - 1};
        const auto c = component(k);
        const auto index = [&](double x) { return int(std::clamp(std::floor((x - low_.*c) / size.*c), -1.0, double(cells_[k]))); };
        const auto b = shape.bounds();
        return {std::max(0, index(b.low.*c - reach)), std::min(cells_[k] - 1, index(b.high.*c + reach))};
    };
    std::vector<std::pair<int, int>> found; // cell, patch
    for (int p = 0; p < int(geometry.patches.size()); ++p)
    {
        const auto& shape = *geometry.patches[p].shape;
        const bool moves = movesAcross(geometry, geometry.patches[p]);
        const auto x = range(shape, 0), y = range(shape, 1), z = range(shape, 2);
        for (int l = z[0]; l <= z[1]; ++l)
            for (int k = y[0]; k <= y[1]; ++k)
                for (int i = x[0]; i <= x[1]; ++i)
                    if (moves || shape.foot(centre(i, k, l)).distance - halfDiagonal <= reach)
                        found.emplace_back((l * cells_[1] + k) * cells_[0] + i, p);
    }
    start_.assign(std::size_t(cells_[0]) * cells_[1] * cells_[2] + 1, 0);
    for (const auto& [c, p] : found) ++start_[c + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    patches_.resize(found.size());
    auto next = start_;
    for (const auto& [c, p] : found) patches_[next[c]++] = p;
}

int PatchGrid::cell(const Vector<3>& x) const
{
    // 2-D: inverseSize_.z is 0.
    const double i = std::floor((x.x - low_.x) * inverseSize_.x), k = std::floor((x.y - low_.y) * inverseSize_.y),
                 l = std::floor((x.z - low_.z) * inverseSize_.z);
    const bool inside = i >= 0 && i < cells_[0] && k >= 0 && k < cells_[1] && l >= 0 && l < cells_[2];
    return inside ? (int(l) * cells_[1] + int(k)) * cells_[0] + int(i) : -1;
}

std::span<const int> PatchGrid::near(const Vector<3>& x) const
{
    const int c = cell(x);
    if (c < 0) return all_;
    return {patches_.data() + start_[c], patches_.data() + start_[c + 1]};
}

}
