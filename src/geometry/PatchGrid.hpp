/// A uniform grid that lists the patches near a point. It covers the domain extended by `reach`, so that beds of thousands of spheres
/// cost the same per particle as one wall.
#pragma once
#include "geometry/Geometry.hpp"
#include <array>
#include <span>
#include <vector>

namespace sph
{

class PatchGrid
{
    Vector<3> low_, inverseSize_;
    std::array<int, 3> cells_{1, 1, 1};
    std::vector<int> start_, patches_; ///< patches of cell c: patches_[start_[c]] to patches_[start_[c + 1] - 1]
    std::vector<int> all_;             ///< the answer outside the grid

    int cell(const Vector<3>& x) const;

public:
    /// A grid of geometry.patches. `reach` [m] is the largest distance at which a patch must be found.
    PatchGrid(const Geometry&, double reach);

    /// Indices into Geometry::patches, ascending, of every patch from which x has a signed distance of at most `reach`, and
    /// some that are further away. Outside the domain extended by `reach`: every patch.
    std::span<const int> near(const Vector<3>& x) const;

    /// Mean number of patches per cell.
    double occupancy() const { return double(patches_.size()) / double(start_.size() - 1); }
};

}
