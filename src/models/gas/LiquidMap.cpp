#include "models/gas/LiquidMap.hpp"
#include "geometry/components.hpp"
#include "parallel/reduce.hpp"
#include <cmath>
#include <limits>

namespace sph
{

namespace
{
/// A particle stands no nearer to a wall [spacings].
constexpr double leastFromWall = 0.45;

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

LiquidMap::LiquidMap(const Geometry& geometry, double spacing) : geometry_(geometry), low_(geometry.low), n_{1, 1, 1}
{
    for (int k = 0; k < 3; ++k)
    {
        size_.*component(k) = spacing;
        if (k >= geometry.dimension) continue;
        n_[std::size_t(k)] = std::max(1, int(std::lround(geometry.length(k) / spacing)));
        size_.*component(k) = geometry.length(k) / n_[std::size_t(k)];
    }
    const std::size_t all = std::size_t(n_[0]) * std::size_t(n_[1]) * std::size_t(n_[2]);
    for (auto* cells : {&liquid_, &enclosed_, &wasOpen_, &place_}) cells->resize(all);
    squared_.resize(all);
#pragma omp parallel for schedule(dynamic, 1024)
    for (std::size_t c = 0; c < all; ++c)
    {
        const double d = geometry.distance(centre(c));
        place_[c] = d < 0 ? solid : d < leastFromWall * spacing ? besideWall : room;
    }
}

std::array<int, 3> LiquidMap::indices(std::size_t cell) const
{
    const auto nx = std::size_t(n_[0]), ny = std::size_t(n_[1]);
    return {int(cell % nx), int(cell / nx % ny), int(cell / (nx * ny))};
}

long LiquidMap::cellAt(std::array<int, 3> index) const
{
    for (std::size_t k = 0; k < 3; ++k)
    {
        if (index[k] >= 0 && index[k] < n_[k]) continue;
        if (int(k) >= geometry_.dimension || !geometry_.periodic[k]) return -1;
        index[k] = (index[k] % n_[k] + n_[k]) % n_[k];
    }
    return index[0] + long(n_[0]) * (index[1] + long(n_[1]) * index[2]);
}

std::size_t LiquidMap::cellOf(const Vector<3>& x) const
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

Vector<3> LiquidMap::centre(std::size_t cell) const
{
    const auto at = indices(cell);
    Vector<3> x;
    for (int k = 0; k < geometry_.dimension; ++k) x.*component(k) = low_.*component(k) + (at[std::size_t(k)] + 0.5) * size_.*component(k);
    return x;
}

std::size_t LiquidMap::blockOf(std::size_t cell, int cells) const
{
    const auto at = indices(cell);
    std::size_t block = 0;
    for (int k = 2; k >= 0; --k) block = block * std::size_t(n_[std::size_t(k)] / cells + 1) + std::size_t(at[std::size_t(k)] / cells);
    return block;
}

Vector<3> LiquidMap::between(const Vector<3>& a, const Vector<3>& b) const
{
    auto d = a - b;
    for (int k = 0; k < geometry_.dimension; ++k)
        if (geometry_.periodic[std::size_t(k)]) d.*component(k) -= geometry_.length(k) * std::round(d.*component(k) / geometry_.length(k));
    return d;
}

void LiquidMap::clear() { std::ranges::fill(liquid_, 0); }

void LiquidMap::measure(double reach)
{
    liquid_ = ofAllRanks(liquid_, std::vector<std::uint8_t>(liquid_.size(), 0), Join{});
    const int cells = int(std::ceil(reach));
#pragma omp parallel for schedule(static)
    for (std::size_t c = 0; c < liquid_.size(); ++c) squared_[c] = liquid_[c] ? 0 : far;
    for (int k = 0; k < geometry_.dimension; ++k) measureAlong(k, cells);
    findEnclosed();
}

/// d^2 <- min over offsets o of d^2(o) + o^2 along a direction: after all directions it is that of the nearest marked cell.
void LiquidMap::measureAlong(int direction, int reach)
{
    const auto k = std::size_t(direction);
    const int n = n_[k];
    const bool around = geometry_.periodic[k];
    const std::size_t stride = k == 0 ? 1 : k == 1 ? std::size_t(n_[0]) : std::size_t(n_[0]) * std::size_t(n_[1]);
#pragma omp parallel for schedule(static)
    for (std::size_t l = 0; l < cells() / std::size_t(n); ++l)
    {
        std::uint16_t* const first = squared_.data() + l % stride + l / stride * stride * std::size_t(n);
        std::vector<std::uint16_t> line; // with `reach` more cells at each end
        for (int q = -reach; q < n + reach; ++q)
            line.push_back((q < 0 || q >= n) && !around ? far : first[std::size_t((q % n + n) % n) * stride]);
        for (int q = 0; q < n; ++q)
        {
            auto least = line[std::size_t(q + reach)];
            for (int o = 1; o <= reach; ++o)
            {
                const auto nearer = std::min(line[std::size_t(q + reach - o)], line[std::size_t(q + reach + o)]);
                least = std::min(least, std::uint16_t(nearer + o * o));
            }
            first[std::size_t(q) * stride] = least;
        }
    }
}

void LiquidMap::findEnclosed()
{
    enum : int
    {
        closed = -1,
        unseen = 0
    };
    std::vector<int> region(cells());
    for (std::size_t c = 0; c < cells(); ++c) region[c] = squared_[c] <= 1 || place_[c] == solid ? closed : unseen;
    std::vector<std::size_t> sizes{0}, front;
    for (std::size_t c = 0; c < cells(); ++c)
    {
        if (region[c] != unseen) continue;
        const int number = int(sizes.size());
        sizes.push_back(0);
        region[c] = number;
        front.assign(1, c);
        while (!front.empty())
        {
            const auto cell = front.back();
            front.pop_back();
            ++sizes.back();
            const auto at = indices(cell);
            for (std::size_t k = 0; k < std::size_t(geometry_.dimension); ++k)
                for (const int side : {-1, 1})
                {
                    auto next = at;
                    next[k] += side;
                    const long other = cellAt(next);
                    if (other < 0 || region[std::size_t(other)] != unseen) continue;
                    region[std::size_t(other)] = number;
                    front.push_back(std::size_t(other));
                }
        }
    }
    const int largest = int(std::ranges::max_element(sizes) - sizes.begin());
    pockets_ = std::max(0, int(sizes.size()) - 2);
    for (std::size_t c = 0; c < cells(); ++c)
    {
        wasOpen_[c] = hasMeasured_ && !enclosed_[c];
        enclosed_[c] = region[c] > 0 && region[c] != largest;
    }
    hasMeasured_ = true;
}

std::size_t LiquidMap::bytes() const { return cells() * (4 * sizeof(std::uint8_t) + sizeof(std::uint16_t)); }

}
