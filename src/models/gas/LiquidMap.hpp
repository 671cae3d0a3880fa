/// Where the liquid is, on cells of one spacing: how far each cell is from it, and which of the gas it encloses.
///
/// The distance of a cell is that of its centre from the centre of the nearest cell that holds liquid, at most `reach`. Gas is enclosed where its cells, joined by
/// their faces, do not lead to the largest such region; what is narrower than three cells between liquids or a liquid and a wall leads nowhere.
///
/// Where ranks share the particles, each marks its own and all get the same map.
#pragma once
#include "geometry/Geometry.hpp"
#include <array>
#include <cstdint>
#include <vector>

namespace sph
{

class LiquidMap
{
public:
    /// Cells over the domain. The geometry must outlive the map.
    LiquidMap(const Geometry&, double spacing);

    void clear();
    void mark(const Vector<3>& x) { liquid_[cellOf(x)] = 1; }
    /// Ends the marking: distances as far as `reach` [spacings], and what is enclosed. All ranks must call it.
    void measure(double reach);

    std::size_t cells() const { return liquid_.size(); }
    std::size_t cellOf(const Vector<3>& x) const;
    Vector<3> centre(std::size_t cell) const;
    /// Number of the block of `cells` along each side that a cell lies in.
    std::size_t blockOf(std::size_t cell, int cells) const;
    /// Distance from the liquid, squared [spacings^2]; more than reach^2 where it is farther.
    int squaredDistance(std::size_t cell) const { return squared_[cell]; }
    bool isEnclosed(std::size_t cell) const { return enclosed_[cell] != 0; }
    /// Enclosed now, and not when last measured.
    bool isClosing(std::size_t cell) const { return enclosed_[cell] != 0 && wasOpen_[cell] != 0; }
    /// Whether a particle may stand at the centre of a cell: not within half a spacing of a wall.
    bool isRoom(std::size_t cell) const { return place_[cell] == room; }
    /// Number of enclosed regions.
    int pockets() const { return pockets_; }
    /// Calls f(cell) for a cell and all that touch it.
    template<class F> void forEachAround(std::size_t cell, const F& f) const;
    /// Vector from b to a, by the shortest way where directions are periodic.
    Vector<3> between(const Vector<3>& a, const Vector<3>& b) const;
    std::size_t bytes() const;

private:
    enum Place : std::uint8_t
    {
        room,
        besideWall,
        solid
    };
    const Geometry& geometry_;
    Vector<3> low_, size_; ///< of the cells; size of one [m]
    std::array<int, 3> n_; ///< of cells along each direction
    std::vector<std::uint8_t> liquid_, enclosed_, wasOpen_, place_;
    std::vector<std::uint16_t> squared_;
    int pockets_ = 0;
    bool hasMeasured_ = false;

    std::array<int, 3> indices(std::size_t cell) const;
    /// Cell of indices that may be outside; -1 where there is none.
    long cellAt(std::array<int, 3> index) const;
    void measureAlong(int direction, int reach);
    void findEnclosed();
};

template<class F> void LiquidMap::forEachAround(std::size_t cell, const F& f) const
{
    const auto at = indices(cell);
    for (int k = n_[2] > 1 ? -1 : 0; k <= (n_[2] > 1 ? 1 : 0); ++k)
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i)
                if (const long other = cellAt({at[0] + i, at[1] + j, at[2] + k}); other >= 0) f(std::size_t(other));
}

}
