/// Where the liquid is and which of the gas it encloses, on cells of one spacing.
///
/// Gas is enclosed where its cells, joined by their faces, do not lead to the largest such region; what is narrower than three cells between liquids or a liquid and a wall leads nowhere.
#pragma once
#include "base/JoinedTrees.hpp"
#include "geometry/OpenPlane.hpp"
#include "models/gas/LiquidDistance.hpp"
#include <functional>

namespace sph
{

/// The planes of openings, at which a scene ends; it has none where nobody knows the nearest.
struct SceneEnds
{
    std::function<std::pair<const OpenPlane*, double>(const Vector<3>&)> nearest =
        {};                      ///< the nearest plane to a point, and the distance from it, < 0 beyond it [m]
    double sight = 0, depth = 0; ///< how far beyond a plane the scene sees, and particles are held [m]
};

class LiquidMap : public LiquidDistance
{
public:
    LiquidMap(const Geometry&, double spacing, SceneEnds = {});

    /// Which cells have room: at first, and again where walls have moved since.
    void findPlaces();

    /// Distances as far as `reach` [spacings], and what is enclosed. All ranks must call it.
    void measure(double reach);

    /// Number of the block of `cells` along each side that a cell lies in.
    std::size_t blockOf(std::size_t cell, int cells) const;
    bool isEnclosed(std::size_t cell) const { return enclosed_[cell] != 0; }
    /// Enclosed now, and not when last measured.
    bool isClosing(std::size_t cell) const { return enclosed_[cell] != 0 && wasOpen_[cell] != 0; }
    /// Whether a particle may stand at the centre of a cell: not within half a spacing of a wall or of the plane of an opening, nor beyond that.
    bool isRoom(std::size_t cell) const { return place_[cell] == room; }
    /// Whether an outlet may hold a particle there that the scene does not see: beyond its plane, farther than the kernel reaches and no farther than is held.
    bool isHeldUnseen(std::size_t cell) const { return place_[cell] == heldUnseen; }
    /// Number of enclosed regions.
    int pockets() const { return pockets_; }
    /// Calls f(cell) for a cell and all that touch it.
    template<class F> void forEachAround(std::size_t cell, const F& f) const;
    /// Calls f(cell) for the cell of a place, and then for those that touch it and begin within `reach` of that place in each direction, at most a cell's width [m], until one is true.
    template<class F> bool anyWithin(const Vector<3>& place, double reach, const F& f) const;
    /// Distance of two points, by the shortest way where directions are periodic.
    double distance(const Vector<3>& a, const Vector<3>& b) const { return mag(geometry_.shortest(a - b)); }
    std::size_t bytes() const { return LiquidDistance::bytes() + cells() * (3 * sizeof(std::uint8_t) + sizeof(int)); }

private:
    enum Place : std::uint8_t
    {
        room,
        besideWall, ///< or near the plane of an opening, or beyond what it holds
        heldUnseen,
        solid
    };
    SceneEnds ends_;
    double spacing_;
    std::vector<std::uint8_t> enclosed_, wasOpen_, place_;
    JoinedTrees regions_; ///< of cells of gas that share faces
    int pockets_ = 0;
    bool hasMeasured_ = false;

    void findEnclosed();
    /// Calls f for the cells at so many places from one in each direction, from first to last, until it is true.
    template<class F> bool anyOf(std::size_t cell, std::array<int, 3> first, std::array<int, 3> last, const F& f) const;
};

template<class F> bool LiquidMap::anyOf(std::size_t cell, std::array<int, 3> first, std::array<int, 3> last, const F& f) const
{
    const auto at = indices(cell);
    for (int k = first[2]; k <= last[2]; ++k)
        for (int j = first[1]; j <= last[1]; ++j)
            for (int i = first[0]; i <= last[0]; ++i)
                if (const long other = cellAt({at[0] + i, at[1] + j, at[2] + k}); other >= 0 && f(std::size_t(other))) return true;
    return false;
}

template<class F> void LiquidMap::forEachAround(std::size_t cell, const F& f) const
{
    const int deep = n_[2] > 1 ? 1 : 0;
    anyOf(cell, {-1, -1, -deep}, {1, 1, deep},
          [&](std::size_t other)
          {
              f(other);
              return false;
          });
}

template<class F> bool LiquidMap::anyWithin(const Vector<3>& place, double reach, const F& f) const
{
    const auto cell = cellOf(place);
    if (f(cell)) return true;
    const auto within = placeInCell(place, cell);
    std::array<int, 3> first{}, last{};
    for (std::size_t c = 0; c < std::size_t(geometry_.dimension); ++c)
    {
        const double most = (1 + 1e-9) * reach; // a particle at the face of a cell is in either
        first[c] = within[c] <= most ? -1 : 0;
        last[c] = size(int(c)) - within[c] <= most ? 1 : 0;
    }
    return anyOf(cell, first, last, [&](std::size_t other) { return other != cell && f(other); });
}

}
