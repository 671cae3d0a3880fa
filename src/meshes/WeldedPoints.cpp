#include "meshes/WeldedPoints.hpp"
#include <algorithm>
#include <cmath>

namespace sph
{

namespace
{

/// Least width of a cell over the box's diagonal: its numbers fit 64 bits, also without a tolerance.
constexpr double leastWidth = 1e-12;

std::uint64_t keyOf(std::int64_t i, std::int64_t j, std::int64_t k)
{
    return std::uint64_t(i) * 0x9E3779B97F4A7C15u ^ std::uint64_t(j) * 0xC2B2AE3D27D4EB4Fu ^ std::uint64_t(k) * 0x165667B19E3779F9u;
}

}

WeldedPoints::WeldedPoints(double tolerance, const Box& box)
    : tolerance_(tolerance), width_(std::max(tolerance, leastWidth * mag(box.high - box.low))), origin_(box.low)
{}

std::array<std::int64_t, 3> WeldedPoints::cellOf(const Vector<3>& x) const
{
    const auto cell = [&](double along) { return std::int64_t(std::floor(along / width_)); };
    const auto r = x - origin_;
    return {cell(r.x), cell(r.y), cell(r.z)};
}

int WeldedPoints::add(const Vector<3>& x)
{
    const auto [i, j, k] = cellOf(x);
    const auto sameIn = [&](std::int64_t di, std::int64_t dj, std::int64_t dk)
    {
        const auto there = first_.find(keyOf(i + di, j + dj, k + dk));
        if (there != first_.end())
            for (int q = there->second; q >= 0; q = next_[std::size_t(q)])
                if (mag(points_[std::size_t(q)] - x) <= tolerance_) return q;
        return -1;
    };
    int same = sameIn(0, 0, 0);
    for (int n = 0; n < 27 && same < 0; ++n)
        if (n != 13) same = sameIn(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
    if (same >= 0) return same;
    const int added = int(points_.size());
    points_.push_back(x);
    const auto [entry, isNew] = first_.try_emplace(keyOf(i, j, k), added);
    next_.push_back(isNew ? -1 : entry->second);
    entry->second = added;
    return added;
}

}
