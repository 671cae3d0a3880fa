/// For each of the first n points, all points within `reach`, itself left out, by a grid of cells.
#pragma once
#include "Points.hpp"
#include <span>
#include <vector>

namespace sph
{

class NeighbourTable
{
public:
    /// `points` are n points and their images behind them.
    void build(const Points& points, std::size_t n, double reach);

    std::size_t size() const { return start_.size() - 1; }
    std::span<const int> of(std::size_t i) const { return {index_.data() + start_[i], index_.data() + start_[i + 1]}; }

private:
    std::vector<std::size_t> start_{0};
    std::vector<int> index_;
};

/// The order of the first n points by cells of edge `size`, x fastest: neighbours in space become neighbours in memory.
std::vector<int> cellOrder(const Points& points, std::size_t n, double size);

}
