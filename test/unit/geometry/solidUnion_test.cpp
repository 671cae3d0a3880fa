/// Solids that touch or overlap act as one: which patches may be covered, which feet are hidden, and which edges are none.
#include "geometry/forEachFoot.hpp"
#include "reading.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test::solidUnionTest
{

namespace
{

constexpr double reach = 0.1;

Geometry scene(const std::string& walls, const std::string& space = square)
{
    const auto [g, errors] = read(space + "walls { " + walls + " }", reach);
    EXPECT_EQ(errors, "");
    return g;
}

const std::string tank = "tank { type box; min (0 0 0); max (1 1 0); fluid inside; } ";
const std::string block = "block { type box; min (0.4 0 0); max (0.6 0.3 0); fluid outside; } ";
constexpr int floorOfTank = 2, blockOnIt = 4; // left right floor lid, then the block

}

// Nothing is asked where no body touches a solid: containers, bodies apart, balls that touch one another or a plane in a point.
TEST(SolidUnion, IsNoneWhereNothingOverlaps)
{
    EXPECT_TRUE(scene(tank).coverers.empty());
    EXPECT_TRUE(scene(tank + "block { type box; min (0.4 0.01 0); max (0.6 0.3 0); fluid outside; }").coverers.empty());
    EXPECT_TRUE(scene("balls { type spheres; spheres ((0.3 0.5 0 0.2) (0.7 0.5 0 0.2)); }").coverers.empty());
    EXPECT_TRUE(scene(tank + "ball { type sphere; centre (0.5 0.2 0); radius 0.2; fluid outside; }").coverers.empty());
}

TEST(SolidUnion, KnowsWhoMayCoverWhom)
{
    const auto g = scene(tank + block);
    for (int p = 0; p < 5; ++p) EXPECT_EQ(g.mayBeCovered(p), p == floorOfTank || p == blockOnIt) << p;
    const auto sunk = scene(tank + "ball { type sphere; centre (0.5 -0.1 0); radius 0.3; fluid outside; }");
    EXPECT_TRUE(sunk.mayBeCovered(floorOfTank));
    const auto boxes = scene(
        "a { type box; min (0.2 0.2 0); max (0.5 0.5 0); fluid outside; } b { type box; min (0.5 0.3 0); max (0.8 0.9 0); fluid outside; }");
    EXPECT_TRUE(boxes.mayBeCovered(0) && boxes.mayBeCovered(1));
    const auto space = scene(
        "floor { type plane; point (0 0 0); normal (0 1 0); } block { type box; min (0.3 -0.2 0.3); max (0.7 0.3 0.7); fluid outside; }",
        "dimension 3; domain { min (0 0 0); max (1 1 1); }\n");
    EXPECT_TRUE(space.mayBeCovered(0) && space.mayBeCovered(1));
}

// Beside the block its face has no lower edge: there is a whole image however near the floor. Its upper edge stays one. The mirror image in the
// floor is mirrored in the face continued below the floor.
TEST(SolidUnion, HasNoEdgeWhereABlockStands)
{
    const auto g = scene(tank + block);
    const Vector<3> low{0.38, 0.001, 0}, high{0.38, 0.299, 0};
    EXPECT_LT(g.originals[blockOnIt].shape->foot(low).margin, 0);
    EXPECT_NEAR(g.foot(blockOnIt, low).margin, 0.1 - 0.02, 1e-15); // as far as half the block's thickness
    EXPECT_EQ(g.foot(blockOnIt, low).exposure, 1);
    EXPECT_TRUE(g.foot(blockOnIt, low).smooth);
    EXPECT_NEAR(g.foot(blockOnIt, high).margin, 0.001 - 0.02, 1e-15);
    const auto ghost = g.footOfGhost(blockOnIt, {0.38, -0.001, 0}, low);
    EXPECT_NEAR(ghost.distance, 0.02, 1e-15);
    EXPECT_EQ(ghost.normal, (Vector<3>{-1, 0, 0}));
    EXPECT_TRUE(ghost.smooth);
}

// From within the block the way out is its side, not the face that stands on the floor; what is on the floor under it is hidden.
TEST(SolidUnion, HidesTheFacesInside)
{
    const auto g = scene(tank + block);
    const Vector<3> inside{0.43, 0.002, 0};
    EXPECT_EQ(g.originals[blockOnIt].shape->foot(inside).normal, (Vector<3>{0, -1, 0}));
    const auto out = g.foot(blockOnIt, inside);
    EXPECT_EQ(out.normal, (Vector<3>{-1, 0, 0}));
    EXPECT_NEAR(out.distance, -0.03, 1e-15);
    EXPECT_EQ(g.foot(floorOfTank, {0.42, 0.31, 0}).exposure, 0);
    int seen = 0;
    forEachFoot(g, {0.38, 0.02, 0}, reach,
                [&](const Foot& f, int p)
                {
                    ++seen;
                    EXPECT_TRUE(p == floorOfTank || p == blockOnIt);
                    EXPECT_EQ(f.on, Foot::On::face);
                });
    EXPECT_EQ(seen, 2);
}

// Of two flush faces one is the wall; across the joint of two blocks side by side there is no edge.
TEST(SolidUnion, HasFlushFacesOnce)
{
    const auto lapped = scene(
        "a { type box; min (0.2 0.2 0); max (0.6 0.5 0); fluid outside; } b { type box; min (0.4 0.2 0); max (0.9 0.5 0); fluid outside; }");
    const Vector<3> above{0.5, 0.52, 0};
    EXPECT_EQ(lapped.foot(0, above).exposure + lapped.foot(1, above).exposure, 1);
    const auto joined = scene(
        "a { type box; min (0.2 0.2 0); max (0.5 0.5 0); fluid outside; } b { type box; min (0.5 0.2 0); max (0.9 0.5 0); fluid outside; }");
    for (const double x : {0.495, 0.505})
    {
        double share = 0;
        for (int p = 0; p < 2; ++p) share += faceShare(joined.foot(p, {x, 0.52, 0}), 0.05);
        EXPECT_EQ(share, 1) << x;
    }
}

// Flat domes on the floor. At 109 degrees of fluid the images of both surfaces leave room between them: all count. At 132 those of the dome
// fade, without a step, towards the floor, where they would lie behind it.
TEST(SolidUnion, FadesBeyondAnObtuseCorner)
{
    const int ball = 4;
    const auto wide = scene(tank + "ball { type sphere; centre (0.5 -0.1 0); radius 0.3; fluid outside; }");
    EXPECT_EQ(wide.foot(ball, {0.5, 0.25, 0}).exposure, 1);
    EXPECT_GT(wide.foot(ball, {0.5 + std::sqrt(0.08) + 0.05, 0.01, 0}).exposure, 0.9);

    const auto flat = scene(tank + "ball { type sphere; centre (0.5 -0.2 0); radius 0.3; fluid outside; }");
    const double contact = 0.5 + std::sqrt(0.05);
    EXPECT_EQ(flat.foot(ball, {contact - 0.05, 0.05, 0}).exposure, 1);
    double last = 1;
    for (double angle = 120; angle > 0; angle -= 1)
    {
        const double a = angle * std::numbers::pi / 180,
                     now = flat.foot(ball, {contact + 0.01 * std::cos(a), 0.01 * std::sin(a), 0}).exposure;
        EXPECT_LE(now, last) << angle;
        EXPECT_LT(last - now, 0.05) << angle;
        last = now;
    }
    EXPECT_LT(last, 0.05);
}

}
