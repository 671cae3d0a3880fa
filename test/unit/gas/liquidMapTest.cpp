/// How far the liquid is from each cell, and which gas it encloses.
#include "models/gas/LiquidMap.hpp"
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <vector>

namespace sph::test
{
namespace
{

/// A square of 40 x 40 cells of 1 m, periodic along x.
Geometry square()
{
    Geometry geometry;
    geometry.dimension = 2;
    geometry.high = {40, 40, 0};
    geometry.periodic = {true, false, false};
    return geometry;
}

/// Marks a ring of liquid of radius 12 about the middle, with a gap of so many cells on its right side.
void markRing(LiquidMap& map, double gap)
{
    map.clear();
    for (int q = 0; q < 2000; ++q)
    {
        const double angle = q * 3.14159265358979 / 1000, x = 12 * std::cos(angle), y = 12 * std::sin(angle);
        for (const double r : {0.95, 1.0, 1.05})
            if (!(x > 0 && std::fabs(y) < 0.5 * gap)) map.mark({20 + r * x, 20 + r * y, 0});
    }
    map.measure(8);
}

TEST(LiquidMap, MeasuresDistancesAcrossPeriodicFacesAlone)
{
    const auto geometry = square();
    LiquidMap map(geometry, 1);
    map.mark({1.5, 1.5, 0});
    map.measure(8);
    const auto squared = [&](double x, double y) { return map.squaredDistance(map.cellOf({x, y, 0})); };
    EXPECT_EQ(squared(1.5, 1.5), 0);
    EXPECT_EQ(squared(4.5, 5.5), 25);
    EXPECT_EQ(squared(38.5, 1.5), 9) << "through the periodic face";
    EXPECT_GT(squared(1.5, 38.5), 64) << "not through the other one";
    EXPECT_GT(squared(20.5, 20.5), 64);
}

// Whether a particle lies nearer to a place than some distance, of particles by cell: by the cells that the map names, as by a look at all. Directions of one cell to five, periodic and not, places outside.
TEST(LiquidMap, NamesTheCellsThatHoldWhatIsNear)
{
    std::mt19937 generator(3);
    for (const int dimension : {2, 3})
        for (const double length : {1.2, 2.4, 3.1, 5.3})
        {
            Geometry geometry;
            geometry.dimension = dimension;
            geometry.high = {length, 4.1, dimension == 3 ? 3.3 : 0};
            geometry.periodic = {true, false, dimension == 3};
            const LiquidMap map(geometry, 1);
            std::uniform_real_distribution<double> share(-0.1, 1.1);
            const auto anywhere = [&]
            {
                const double x = std::clamp(share(generator), 0.0, 0.999999);
                return Vector<3>{x * geometry.high.x, share(generator) * geometry.high.y,
                                 dimension == 3 ? share(generator) * geometry.high.z : 0};
            };
            std::vector<Vector<3>> particles(12);
            std::vector<std::vector<std::size_t>> inCell(map.cells());
            for (std::size_t j = 0; j < particles.size(); ++j) inCell[map.cellOf(particles[j] = anywhere())].push_back(j);
            int near = 0;
            for (int k = 0; k < 400; ++k)
            {
                const auto place = anywhere();
                const double gap = 0.3 + 0.2 * (k % 3);
                const auto isNear = [&](std::size_t j) { return map.distance(particles[j], place) < gap; };
                const bool any = map.anyWithin(place, gap, [&](std::size_t cell) { return std::ranges::any_of(inCell[cell], isNear); });
                bool expected = false;
                for (std::size_t j = 0; j < particles.size(); ++j) expected = expected || isNear(j);
                EXPECT_EQ(any, expected) << dimension << ' ' << length << ' ' << k;
                near += expected;
            }
            EXPECT_GT(near, 20);
            EXPECT_LT(near, 380);
        }
}

TEST(LiquidMap, FindsWhatIsEnclosedAndWhatHasJustBeen)
{
    const auto geometry = square();
    LiquidMap map(geometry, 1);
    const auto middle = map.cellOf({20, 20, 0}), outside = map.cellOf({2, 2, 0});
    markRing(map, 6);
    EXPECT_FALSE(map.isEnclosed(middle)) << "open through a gap of six cells";
    EXPECT_EQ(map.pockets(), 0);
    markRing(map, 0);
    EXPECT_TRUE(map.isEnclosed(middle));
    EXPECT_TRUE(map.isClosing(middle)) << "it was open when last measured";
    EXPECT_FALSE(map.isEnclosed(outside)) << "the largest region is open";
    EXPECT_EQ(map.pockets(), 1);
    markRing(map, 0);
    EXPECT_FALSE(map.isClosing(middle)) << "it has been enclosed before";
}

// A box of 13 x 9 x 11 cells, periodic along x and z, with liquid in an eighth of them: distances by a search over all of it, and regions by a walk from cell to cell.
TEST(LiquidMap, AgreesWithAPlainSearchIn3D)
{
    Geometry geometry;
    geometry.dimension = 3;
    geometry.low = {0, 0, 0};
    geometry.high = {13, 9, 11};
    geometry.periodic = {true, false, true};
    const std::array<int, 3> n{13, 9, 11};
    using Cell = std::array<int, 3>;
    const auto centre = [](const Cell& c) { return Vector<3>{c[0] + 0.5, c[1] + 0.5, c[2] + 0.5}; };
    std::vector<Cell> all;
    for (int x = 0; x < n[0]; ++x)
        for (int y = 0; y < n[1]; ++y)
            for (int z = 0; z < n[2]; ++z) all.push_back({x, y, z});
    std::mt19937_64 random(5);
    int pocketsOfAll = 0;
    for (int turn = 0; turn < 5; ++turn)
    {
        LiquidMap map(geometry, 1);
        std::vector<Cell> liquid;
        for (const auto& c : all)
            if (random() % 8 == 0) liquid.push_back(c);
        for (const auto& c : liquid) map.mark(centre(c));
        map.measure(3);
        std::map<Cell, int> region; // of cells farther than 1 from the liquid; 0 as long as nobody has been there
        for (const auto& c : all)
        {
            int least = 1000;
            for (const auto& other : liquid)
            {
                int squared = 0;
                for (std::size_t k = 0; k < 3; ++k)
                {
                    const int d = std::abs(c[k] - other[k]);
                    squared += sqr(geometry.periodic[k] ? std::min(d, n[k] - d) : d);
                }
                least = std::min(least, squared);
            }
            EXPECT_EQ(std::min(10, map.squaredDistance(map.cellOf(centre(c)))), std::min(10, least));
            if (least > 1) region[c] = 0;
        }
        std::vector<int> sizes;
        for (auto& [from, number] : region)
        {
            if (number > 0) continue;
            sizes.push_back(0);
            std::vector<Cell> front{from};
            number = int(sizes.size());
            while (!front.empty())
            {
                const auto c = front.back();
                front.pop_back();
                ++sizes.back();
                for (std::size_t k = 0; k < 3; ++k)
                    for (const int side : {-1, 1})
                    {
                        auto next = c;
                        next[k] += side;
                        if (geometry.periodic[k]) next[k] = (next[k] + n[k]) % n[k];
                        if (const auto found = region.find(next); found != region.end() && found->second == 0)
                        {
                            found->second = int(sizes.size());
                            front.push_back(next);
                        }
                    }
            }
        }
        ASSERT_EQ(std::ranges::count(sizes, std::ranges::max(sizes)), 1) << "one region is the largest";
        EXPECT_EQ(map.pockets(), int(sizes.size()) - 1);
        pocketsOfAll += map.pockets();
        for (const auto& c : all)
        {
            const auto found = region.find(c);
            const bool inPocket = found != region.end() && sizes[std::size_t(found->second) - 1] < std::ranges::max(sizes);
            EXPECT_EQ(map.isEnclosed(map.cellOf(centre(c))), inPocket);
        }
    }
    EXPECT_GT(pocketsOfAll, 10);
}

// The plane of an opening at y = 20: gas may join before it, be held where the scene does not see it, and stand nowhere else.
TEST(LiquidMap, KnowsWhatOpeningsHoldUnseen)
{
    const auto geometry = square();
    OpenPlane inlet, outlet;
    outlet.inlet = false;
    const LiquidMap map(geometry, 1, {[&](const Vector<3>& x) { return std::pair(x.x > 10 ? &outlet : &inlet, x.y - 20); }, 3, 8});
    const auto is = [&](double y, double x = 20.5)
    {
        const auto cell = map.cellOf({x, y, 0});
        return std::pair{map.isRoom(cell), map.isHeldUnseen(cell)};
    };
    EXPECT_EQ(is(20.5), std::pair(true, false));
    EXPECT_EQ(is(19.5), std::pair(false, false)) << "the scene sees it";
    EXPECT_EQ(is(17.5), std::pair(false, false));
    EXPECT_EQ(is(16.5), std::pair(false, true));
    EXPECT_EQ(is(12.5), std::pair(false, true));
    EXPECT_EQ(is(12.5, 5.5), std::pair(false, false)) << "beyond an inlet";
    EXPECT_EQ(is(11.5), std::pair(false, false)) << "farther than is held";
    const LiquidMap closed(geometry, 1);
    EXPECT_TRUE(closed.isRoom(closed.cellOf({20.5, 11.5, 0})));
}

}
}
