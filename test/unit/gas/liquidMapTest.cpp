/// How far the liquid is from each cell, and which gas it encloses.
#include "models/gas/LiquidMap.hpp"
#include <gtest/gtest.h>

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
