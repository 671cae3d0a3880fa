/// How far the liquid is, on cells of one spacing: the distance of a cell is that of its centre from the centre of the nearest cell that holds liquid, at most `reach`.
///
/// Where ranks share the particles, each marks its own and all get the same distances.
#pragma once
#include "geometry/Geometry.hpp"
#include "geometry/components.hpp"
#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

namespace sph
{

class LiquidDistance
{
public:
    /// Cells over the domain. The geometry must outlive them.
    LiquidDistance(const Geometry&, double spacing);

    void clear();
    /// Several threads may mark at once.
    void mark(const Vector<3>& x) { std::atomic_ref(liquid_[cellOf(x)]).store(1, std::memory_order_relaxed); }
    /// Ends the marking: distances as far as `reach` [spacings]. All ranks must call it.
    void measure(double reach);

    std::size_t cells() const { return liquid_.size(); }
    std::size_t cellOf(const Vector<3>& x) const;
    Vector<3> centre(std::size_t cell) const;
    /// Distance from the liquid, squared [spacings^2]; more than reach^2 where it is farther.
    int squaredDistance(std::size_t cell) const { return squared_[cell]; }
    std::size_t bytes() const { return cells() * (sizeof(std::uint8_t) + sizeof(std::uint16_t)); }

protected:
    const Geometry& geometry_;
    std::array<int, 3> n_{1, 1, 1}; ///< of cells along each direction

    std::array<int, 3> indices(std::size_t cell) const;
    /// Cell of indices that may be outside; -1 where there is none.
    long cellAt(std::array<int, 3> index) const;
    /// How far a place is from where its cell begins in each direction; outside of the cells, from where the nearest does [m].
    std::array<double, 3> placeInCell(const Vector<3>& x, std::size_t cell) const;
    /// Length of a cell [m].
    double size(int direction) const { return size_.*component(direction); }

private:
    Vector<3> low_, size_; ///< of the cells; size of one [m]
    std::vector<std::uint8_t> liquid_;
    std::vector<std::uint16_t> squared_;

    void measureAlong(int direction, int reach);
};

}
