/// A grid of cells that store the distance to a surface, each when it is first asked for, so that of most places far off no search is needed.
#pragma once
#include "geometry/Shape.hpp"
#include <array>
#include <atomic>
#include <vector>

namespace sph
{

class DistanceGrid
{
    Vector<3> low_;
    double size_ = 0;
    std::array<int, 3> cells_{};
    mutable std::vector<std::atomic<float>> atMiddle_; ///< signed distance of a cell's middle [m]; NaN until asked for

public:
    DistanceGrid() = default;
    /// Cells of `size` [m] over `bounds`, larger ones where they would be too many.
    DistanceGrid(const Box& bounds, double size);

    /// A lower bound of the signed distance of x, d(c) - |x - c| from the middle c of its cell; minus infinity outside. `distance(c)` finds d.
    template<class Distance> double atLeast(const Vector<3>& x, const Distance& distance) const
    {
        const auto [index, middle] = cellOf(x);
        if (index < 0) return -Box::infinity;
        auto& known = atMiddle_[std::size_t(index)];
        float d = known.load(std::memory_order_relaxed);
        if (d != d)
        {
            d = float(distance(middle));
            known.store(d, std::memory_order_relaxed);
        }
        return double(d) - 1e-6 * (size_ + (d < 0 ? -d : d)) - mag(x - middle); // a float is rounded
    }

private:
    struct Cell
    {
        long index = -1;
        Vector<3> middle;
    };
    Cell cellOf(const Vector<3>& x) const;
};

}
