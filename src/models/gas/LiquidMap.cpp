#include "models/gas/LiquidMap.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{
/// A particle stands no nearer to a wall [spacings].
constexpr double leastFromWall = 0.45;
}

LiquidMap::LiquidMap(const Geometry& geometry, double spacing, const SceneEnds& ends) : LiquidDistance(geometry, spacing)
{
    for (auto* each : {&enclosed_, &wasOpen_, &place_}) each->resize(cells());
#pragma omp parallel for schedule(dynamic, 1024)
    for (std::size_t c = 0; c < cells(); ++c)
    {
        const double d = geometry.distance(centre(c)), least = leastFromWall * spacing;
        const auto [plane, s] = ends.nearest ? ends.nearest(centre(c)) : std::pair<const OpenPlane*, double>{nullptr, Box::infinity};
        const bool isHeld = plane && !plane->inlet && -s >= ends.sight && -s < ends.depth && d >= least;
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

Vector<3> LiquidMap::between(const Vector<3>& a, const Vector<3>& b) const
{
    auto d = a - b;
    for (int k = 0; k < geometry_.dimension; ++k)
        if (geometry_.periodic[std::size_t(k)]) d.*component(k) -= geometry_.length(k) * std::round(d.*component(k) / geometry_.length(k));
    return d;
}

void LiquidMap::measure(double reach)
{
    LiquidDistance::measure(reach);
    findEnclosed();
}

void LiquidMap::findEnclosed()
{
    enum : int
    {
        closed = -1,
        unseen = 0
    };
    std::vector<int> region(cells());
    for (std::size_t c = 0; c < cells(); ++c) region[c] = squaredDistance(c) <= 1 || place_[c] == solid ? closed : unseen;
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

}
