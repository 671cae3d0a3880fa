#include "geometry/DistanceGrid.hpp"
#include "geometry/components.hpp"
#include <algorithm>
#include <cmath>
#include <limits>

namespace sph
{

namespace
{
constexpr double mostCells = 1 << 21;
}

DistanceGrid::DistanceGrid(const Box& bounds, double size) : low_(bounds.low)
{
    double volume = 1;
    for (const auto c : coordinates) volume *= std::max(bounds.high.*c - low_.*c, size);
    size_ = std::max(size, std::cbrt(volume / mostCells));
    std::size_t n = 1, k = 0;
    for (const auto c : coordinates) n *= std::size_t(cells_[k++] = std::max(1, int(std::ceil((bounds.high.*c - low_.*c) / size_))));
    atMiddle_ = std::vector<std::atomic<float>>(n);
    for (auto& d : atMiddle_) d.store(std::numeric_limits<float>::quiet_NaN(), std::memory_order_relaxed);
}

DistanceGrid::Cell DistanceGrid::cellOf(const Vector<3>& x) const
{
    Cell cell{0, low_};
    long stride = 1;
    std::size_t k = 0;
    for (const auto c : coordinates)
    {
        const double at = std::floor((x.*c - low_.*c) / size_);
        if (!(at >= 0 && at < cells_[k])) return {};
        cell.index += stride * long(at);
        cell.middle.*c += (at + 0.5) * size_;
        stride *= cells_[k++];
    }
    return cell;
}

}
