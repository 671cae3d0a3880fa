/// Boxes of ranks in a tree: the same ranks as a look at each box finds.
#include "neighbours/RankBoxes.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace sph::test
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();

/// 3 x 5 x 2 boxes that fill space: cuts at 1, 2 along x; 1, 2, 3, 4 along y; 1 along z.
std::vector<RankBox> boxes()
{
    const auto low = [](int k) { return k == 0 ? -infinity : double(k); };
    const auto high = [](int k, int n) { return k == n - 1 ? infinity : double(k + 1); };
    std::vector<RankBox> all;
    for (int x = 0; x < 3; ++x)
        for (int y = 0; y < 5; ++y)
            for (int z = 0; z < 2; ++z) all.push_back({{low(x), low(y), low(z)}, {high(x, 3), high(y, 5), high(z, 2)}});
    return all;
}

TEST(RankBoxes, FindWhatIsNearAndWhoOwnsAPlace)
{
    const auto all = boxes();
    const RankBoxes tree(all);
    ASSERT_EQ(tree.count(), 30);
    const double reach = 0.3;
    for (int k = 0; k < 3000; ++k)
    {
        const Vector<3> x{-0.5 + 0.27 * (k % 15), -0.5 + 0.31 * (k / 15 % 20), 0.25 * (k / 300)};
        const int expected = std::min(std::max(int(x.x), 0), 2) * 10 + std::min(std::max(int(x.y), 0), 4) * 2 + std::min(int(x.z), 1);
        EXPECT_EQ(tree.owner(x), expected);
        EXPECT_EQ(RankBoxes::squaredDistance(tree.of(expected), x), 0);
        std::vector<int> near, nearEach;
        tree.forEachNear(x, reach, [&](int r) { near.push_back(r); });
        for (int r = 0; r < 30; ++r)
            if (RankBoxes::squaredDistance(tree.of(r), x) < reach * reach) nearEach.push_back(r);
        EXPECT_EQ(near, nearEach);
        for (int r = 0; r < 30; ++r) EXPECT_EQ(RankBoxes::holds(tree.of(r), x), r == expected);
        EXPECT_EQ(RankBoxes::holdsAround(tree.of(expected), x, reach), near.size() == 1);
    }
    // Lower faces belong to a box, upper ones to the next.
    EXPECT_EQ(tree.owner({1, 2, 1}), 10 + 4 + 1);
    EXPECT_DOUBLE_EQ(RankBoxes::squaredDistance(tree.of(0), {2, 3, 0}), 1 + 4);
    EXPECT_EQ(tree.owner({std::nan(""), 0, 0}), -1);
}

}
}
