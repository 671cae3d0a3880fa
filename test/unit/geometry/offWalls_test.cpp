/// Positions and velocities are held off walls, one after the other.
#include "geometry/offWalls.hpp"
#include "wallsByHand.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test
{
namespace
{

// Off the floor and off the block at once; the walls that it was put off are told. In a slit narrower than twice the distance it stays between the two.
TEST(OffWalls, HoldsOffAllWallsInTurn)
{
    Geometry geometry = tankWithBlock();
    const NearWalls walls(geometry, 0.2);
    std::vector<Vector<2>> normals;
    const auto corner = offWalls(walls, Vector<2>{0.399, 0.002}, {0.01}, 0.025, [&](const Vector<2>& n, int) { normals.push_back(n); });
    EXPECT_NEAR(corner.x, 0.39, 1e-15);
    EXPECT_NEAR(corner.y, 0.01, 1e-15);
    EXPECT_EQ(normals, (std::vector<Vector<2>>{{-1, 0}, {0, 1}}));
    const Vector<2> free{0.38, 0.4};
    EXPECT_EQ(offWalls(walls, free, {0.01}, 0.025, [&](const Vector<2>&, int) { ADD_FAILURE(); }), free);

    addWall(geometry, SolidBox({0.1, 0.004, -Box::infinity}, {0.3, 0.2, Box::infinity}));
    repeatPeriodically(geometry, 0.2);
    const NearWalls withSlit(geometry, 0.2);
    const auto between = offWalls(withSlit, Vector<2>{0.2, 0.003}, {0.003}, 0.025, [](const Vector<2>&, int) {});
    EXPECT_GE(between.y, 0);
    EXPECT_LE(between.y, 0.004);
}

// Towards the tip of a wedge of 30 degrees: held between its sides, whatever the turns; along its edge nothing holds. In a corner of 120 degrees the
// one leaves the other nothing to take.
TEST(OffWalls, TakeAllThatPointsIntoAWedge)
{
    const Vector<2> floor{0, 1}, overhang{std::sin(std::numbers::pi / 6), -std::cos(std::numbers::pi / 6)};
    HeldVelocity<2> inPlane({-1, -0.2});
    HeldVelocity<3> inSpace({-1, -0.2, 0.7});
    for (int turn = 0; turn < 2; ++turn)
    {
        inPlane.touch(floor, 0);
        inPlane.touch(overhang, 0);
        inSpace.touch(in3D(floor), 0);
        inSpace.touch(in3D(overhang), 0);
    }
    EXPECT_EQ(Vector<2>(inPlane), (Vector<2>{}));
    EXPECT_NEAR(mag(Vector<3>(inSpace) - Vector<3>{0, 0, 0.7}), 0, 1e-15);
    HeldVelocity<2> outOfCorner({1, -1});
    outOfCorner.touch(floor, 0);
    outOfCorner.touch({std::sin(2 * std::numbers::pi / 3), -std::cos(2 * std::numbers::pi / 3)}, 0);
    EXPECT_EQ(Vector<2>(outOfCorner), (Vector<2>{1, 0}));
}

// A particle a rounding short of a wall touches it again, by a normal that differs by roundings: one wall still, along which it goes on.
TEST(OffWalls, TakeAWallThatIsTouchedTwiceForOne)
{
    for (int k = 0; k < 1000; ++k)
    {
        const double a = 0.7 * k, b = 0.3 * k, rounding = 1e-16 * (k % 7 - 3);
        const Vector<3> n{std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)}, again{n.x + rounding, n.y - rounding, n.z};
        const auto v = -3 * n + Vector<3>{std::sin(2 * a), std::cos(3 * b), 0.5};
        HeldVelocity<3> inSpace(v);
        HeldVelocity<2> inPlane(in<2>(v));
        const auto along = withoutInward(v, n);
        const auto nInPlane = in<2>(n) / mag(in<2>(n)), againInPlane = in<2>(again) / mag(in<2>(again));
        for (const auto& normal : {n, again, n}) inSpace.touch(normal, 0);
        for (const auto& normal : {nInPlane, againInPlane, nInPlane}) inPlane.touch(normal, 0);
        ASSERT_NEAR(mag(Vector<3>(inSpace) - along), 0, 1e-14) << k;
        ASSERT_NEAR(mag(Vector<2>(inPlane) - withoutInward(in<2>(v), nInPlane)), 0, 1e-14) << k;
    }
}

}
}
