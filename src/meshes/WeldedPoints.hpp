/// Points by place: two within a tolerance of each other have one number.
#pragma once
#include "geometry/Shape.hpp"
#include <array>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace sph
{

class WeldedPoints
{
    double tolerance_, width_;
    Vector<3> origin_;
    std::unordered_map<std::uint64_t, int> first_; ///< point of each cell; the others follow by `next_`
    std::vector<int> next_;
    std::vector<Vector<3>> points_;

    /// A cell is at least as wide as the tolerance: what is near lies in the same one or in the next.
    std::array<std::int64_t, 3> cellOf(const Vector<3>&) const;

public:
    /// The tolerance [m], which may be 0, and the box of the points.
    WeldedPoints(double tolerance, const Box&);

    /// The number of the point, or of an earlier one within the tolerance.
    int add(const Vector<3>&);
    const Vector<3>& operator[](int point) const { return points_[std::size_t(point)]; }
    const std::vector<Vector<3>>& all() const { return points_; }
    double tolerance() const { return tolerance_; }
};

}
