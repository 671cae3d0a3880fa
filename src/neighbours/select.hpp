/// Selection of the candidates within a radius from a run of them: the inner loop of list building.
///
/// Places are whole numbers of a unit, 2^-30 of the extent of all points or of the radius where that is more: a vector holds twice as many of them as doubles, and their differences
/// are exact. Rounding moves a distance by up to 3^(1/2) units, and floats by less than a millionth: the radius is longer by two units and a millionth of itself, so that nothing within
/// it is missed, and what is found lies within four units and a millionth of it.
///
/// GCC 12 does not vectorise a loop that appends; a compress in registers does it (the form of AVX-512 that writes to memory is slow on some
/// machines).
#pragma once
#include "base/values.hpp"
#include "neighbours/lanes.hpp"
#include <algorithm>

namespace sph
{

/// How places in a box become whole numbers. A place that is not finite becomes the least of all integers.
template<int dim> class WholePlaces
{
    std::array<double, dim> low_{};
    double perUnit_ = 0;

public:
    WholePlaces() = default;
    /// `extent`, of all points in the direction in which they reach farthest, and `radius` [m] of what is asked for.
    WholePlaces(const std::array<double, dim>& low, double extent, double radius) : low_(low), perUnit_(0x1p30 / std::max(extent, radius))
    {}

    int operator()(int c, double x) const { return detail::rounded((x - low_[std::size_t(c)]) * perUnit_); }
    std::array<int, dim> operator()(Vector<dim> x) const
    {
        std::array<int, dim> place;
        store(x, [&](int c, double q) { place[std::size_t(c)] = (*this)(c, q); });
        return place;
    }
    /// The square of a distance, in these units, that holds all within the radius.
    float limit(double radius) const { return float(sqr((1 + 1e-6) * radius * perUnit_ + 2)); }
};

/// Points in the order of their cells. Each array goes on for `readBeyond` more entries of any value.
template<int dim> struct SortedPoints
{
    static constexpr int readBeyond = 2 * WidestLanes::count;
    const int* place[dim];
    const int* index;
};

/// Writes the index of each point in [begin, end) whose place differs from x by less than the square root of `limit` to `out`, and returns their number. `out` needs room for 16 more.
template<int dim, class L = WidestLanes>
inline int selectWithin(const SortedPoints<dim>& points, int begin, int end, const std::array<int, dim>& x, float limit, int* out)
{
    using Wide = FloatLanes<2 * L::count>;
    const auto within = limit - typename Wide::Floats{};
    const auto [place, index] = points; // in registers: for all that the compiler knows, what is written might change `points`
    int found = 0;
    for (int b = begin; b < end; b += Wide::count)
    {
        const auto difference = [&](int c)
        { return Wide::asFloats(L::template load<typename Wide::Ints>(place[c] + b) - x[std::size_t(c)]); };
        auto square = difference(0) * difference(0);
        for (int c = 1; c < dim; ++c) square += difference(c) * difference(c);
        const unsigned ofRun = (2u << (std::min(end - b, Wide::count) - 1)) - 1;
        found += Wide::append(out + found, index + b, Wide::less(square, within) & ofRun);
    }
    return found;
}

}
