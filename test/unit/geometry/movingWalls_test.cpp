/// Walls that move across themselves; all others stay.
#include "geometry/MovingWalls.hpp"
#include "reading.hpp"
#include <gtest/gtest.h>

using namespace sph;
using namespace sph::test;

namespace
{

// A platen that comes down and a belt: the one is where its velocity has brought it, and found there, the other stays.
TEST(MovingWalls, GoOnByTheirVelocity)
{
    auto g =
        read(
            "dimension 2; domain { min (0 0 0); max (1 1 0); } walls { belt { type plane; point (0 0 0); normal (0 1 0); velocity (3 0 0); } "
            "platen { type plane; point (0 1 0); normal (0 -1 0); velocity (0 -2 0); } }")
            .geometry;
    EXPECT_FALSE(movesAcross(g, g.patches[0]));
    EXPECT_TRUE(movesAcross(g, g.patches[1]));
    const auto before = g;
    MovingWalls walls(g);
    ASSERT_TRUE(walls.any());
    walls.advance(g, 0.1);
    walls.advance(g, 0.15);
    EXPECT_NEAR(g.distance({0.5, 0.4, 0}), 0.1, 1e-15);
    EXPECT_NEAR(g.distance({0.5, 0.2, 0}), 0.2, 1e-15);
    EXPECT_NEAR(before.distance({0.5, 0.8, 0}), 0.2, 1e-15) << "the geometry that was read is another";
    EXPECT_EQ(walls.travelled(), 0.5);
    EXPECT_EQ(walls.speedAlong(g, 1, {0, -1, 0}), 2);
    EXPECT_EQ(walls.speedAlong(g, 0, {0, 1, 0}), 0);
}

// A footing that is pressed down, without an end across the plane of the scene, and a ball: both are where their velocity has brought them, and push with each of their faces by its own normal.
TEST(MovingWalls, MayBeBodies)
{
    auto g =
        read(
            "dimension 2; domain { min (0 0 0); max (4 4 0); } walls { footing { type box; min (1 3 0); max (2 4 0); fluid outside; velocity (0 -0.5 0); } "
            "ball { type sphere; centre (3 1 0); radius 0.3; fluid outside; velocity (0 0.1 0); } belt { type plane; point (0 0 0); normal (0 1 0); } }")
            .geometry;
    MovingWalls walls(g);
    ASSERT_TRUE(walls.any());
    walls.advance(g, 0.4);
    EXPECT_NEAR(g.distance({1.5, 2, 0}), 0.8, 1e-15);
    EXPECT_NEAR(g.distance({3, 1.5, 0}), 0.16, 1e-15);
    EXPECT_EQ(walls.speedAlong(g, 0, {0, -1, 0}), 0.5);
    EXPECT_EQ(walls.speedAlong(g, 0, {1, 0, 0}), 0);
    EXPECT_EQ(walls.speedAlong(g, 2, {0, 1, 0}), 0);
    EXPECT_EQ(walls.fastest(), 0.5);
}

}
