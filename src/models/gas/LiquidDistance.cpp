#include "models/gas/LiquidDistance.hpp"
#include "parallel/reduce.hpp"
#include <cmath>
#include <limits>

namespace sph
{

namespace
{
/// Squared distance of what is out of reach [spacings^2].
constexpr std::uint16_t far = std::numeric_limits<std::uint16_t>::max() / 2;

struct Join
{
    void operator()(std::vector<std::uint8_t>& all, const std::vector<std::uint8_t>& part) const
    {
        for (std::size_t c = 0; c < all.size(); ++c) all[c] |= part[c];
    }
};
}

LiquidDistance::LiquidDistance(const Geometry& geometry, double spacing) : geometry_(geometry), low_(geometry.low)
{
    for (int k = 0; k < 3; ++k)
    {
        size_.*component(k) = spacing;
        if (k >= geometry.dimension) continue;
        n_[std::size_t(k)] = std::max(1, int(std::lround(geometry.length(k) / spacing)));
        size_.*component(k) = geometry.length(k) / n_[std::size_t(k)];
    }
    liquid_.resize(std::size_t(n_[0]) * std::size_t(n_[1]) * std::size_t(n_[2]));
    squared_.resize(liquid_.size());
}

std::array<int, 3> LiquidDistance::indices(std::size_t cell) const
{
    const auto nx = std::size_t(n_[0]), ny = std::size_t(n_[1]);
    return {int(cell % nx), int(cell / nx % ny), int(cell / (nx * ny))};
}

long LiquidDistance::cellAt(std::array<int, 3> index) const
{
    for (std::size_t k = 0; k < 3; ++k)
    {
        if (index[k] >= 0 && index[k] < n_[k]) continue;
        if (int(k) >= geometry_.dimension || !geometry_.periodic[k]) return -1;
        index[k] = (index[k] % n_[k] + n_[k]) % n_[k];
    }
    return index[0] + long(n_[0]) * (index[1] + long(n_[1]) * index[2]);
}

std::size_t LiquidDistance::cellOf(const Vector<3>& x) const
{
    std::array<int, 3> index{};
    for (std::size_t k = 0; k < std::size_t(geometry_.dimension); ++k)
    {
        const double place = std::floor((x.*component(int(k)) - low_.*component(int(k))) / size_.*component(int(k)));
        if (geometry_.periodic[k]) index[k] = int(place - n_[k] * std::floor(place / n_[k]));
        else index[k] = int(std::clamp(place, 0.0, double(n_[k] - 1)));
    }
    return std::size_t(cellAt(index));
}

std::array<double, 3> LiquidDistance::placeInCell(const Vector<3>& x, std::size_t cell) const
{
    const auto at = indices(cell);
    std::array<double, 3> place{};
    for (int k = 0; k < geometry_.dimension; ++k)
    {
        const double beyond = x.*component(k) - low_.*component(k) - at[std::size_t(k)] * size(k);
        place[std::size_t(k)] =
            geometry_.periodic[k] ? beyond - geometry_.length(k) * std::round((beyond - 0.5 * size(k)) / geometry_.length(k)) : beyond;
    }
    return place;
}

Vector<3> LiquidDistance::centre(std::size_t cell) const
{
    const auto at = indices(cell);
    Vector<3> x;
    for (int k = 0; k < geometry_.dimension; ++k) x.*component(k) = low_.*component(k) + (at[std::size_t(k)] + 0.5) * size_.*component(k);
    return x;
}

void LiquidDistance::clear() { std::ranges::fill(liquid_, 0); }

void LiquidDistance::measure(double reach)
{
    liquid_ = ofAllRanks(liquid_, std::vector<std::uint8_t>(liquid_.size(), 0), Join{});
    const int cells = int(std::ceil(reach));
#pragma omp parallel for schedule(static)
    for (std::size_t c = 0; c < liquid_.size(); ++c) squared_[c] = liquid_[c] ? 0 : far;
    for (int k = 0; k < geometry_.dimension; ++k) measureAlong(k, cells);
}

/// d^2 <- min over offsets o of d^2(o) + o^2 along a direction: after all directions it is that of the nearest marked cell.
void LiquidDistance::measureAlong(int direction, int reach)
{
    const auto k = std::size_t(direction);
    const int n = n_[k];
    const bool around = geometry_.periodic[k];
    const std::size_t stride = k == 0 ? 1 : k == 1 ? std::size_t(n_[0]) : std::size_t(n_[0]) * std::size_t(n_[1]);
#pragma omp parallel for schedule(static)
    for (std::size_t l = 0; l < cells() / std::size_t(n); ++l)
    {
        std::uint16_t* const first = squared_.data() + l % stride + l / stride * stride * std::size_t(n);
        std::vector<std::uint16_t> line(std::size_t(n + 2 * reach), far); // with `reach` more cells at each end
        std::vector<std::uint16_t> least(std::size_t(n), far);
        bool isFar = true;
        for (int q = 0; q < n; ++q)
        {
            line[std::size_t(q + reach)] = least[std::size_t(q)] = first[std::size_t(q) * stride];
            isFar = isFar && least[std::size_t(q)] == far;
        }
        if (isFar) continue;
        for (int q = 0; around && q < reach; ++q)
        {
            line[std::size_t(q)] = least[std::size_t(((q - reach) % n + n) % n)];
            line[std::size_t(reach + n + q)] = least[std::size_t(q % n)];
        }
        for (int o = 1; o <= reach; ++o)
        {
            const std::uint16_t *const before = line.data() + reach - o, *const behind = line.data() + reach + o;
            const auto further = std::uint16_t(o * o);
            for (int q = 0; q < n; ++q)
                least[std::size_t(q)] = std::min(least[std::size_t(q)], std::uint16_t(std::min(before[q], behind[q]) + further));
        }
        for (int q = 0; q < n; ++q) first[std::size_t(q) * stride] = least[std::size_t(q)];
    }
}

}
