/// Blocks of cells of a regular grid.
#pragma once
#include "base/Vector.hpp"
#include <array>

namespace sph
{

/// The grid of cells; in 2-D one layer at z = 0, without extent along z.
struct RegularCells
{
    Vector<3> low, step; ///< [m]
};

/// low <= i < high along each direction
struct CellRange
{
    std::array<long, 3> low{}, high{};

    bool contains(const std::array<long, 3>& cell) const
    {
        for (std::size_t k = 0; k < 3; ++k)
            if (cell[k] < low[k] || cell[k] >= high[k]) return false;
        return true;
    }
    bool operator==(const CellRange&) const = default;
};

}
