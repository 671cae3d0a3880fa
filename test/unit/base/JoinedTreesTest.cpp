#include "base/JoinedTrees.hpp"
#include <gtest/gtest.h>

using sph::JoinedTrees;

// 0 1 2 and 4 5 are joined, whichever way round and however often; 3 is left out, and joins nothing.
TEST(JoinedTrees, KnowTheLeastOfEachGroup)
{
    JoinedTrees trees;
    trees.reset(6, [](std::size_t i) { return i != 3; });
    for (const auto& [a, b] : {std::pair(2, 1), std::pair(5, 4), std::pair(0, 2), std::pair(1, 0), std::pair(2, 3), std::pair(3, 4)})
        trees.join(std::size_t(a), std::size_t(b));
    EXPECT_FALSE(trees.isIn(3));
    for (const int i : {0, 1, 2}) EXPECT_EQ(trees.rootOf(std::size_t(i)), 0) << i;
    for (const int i : {4, 5}) EXPECT_EQ(trees.rootOf(std::size_t(i)), 4) << i;
    trees.reset(2);
    EXPECT_NE(trees.rootOf(0), trees.rootOf(1));
}
