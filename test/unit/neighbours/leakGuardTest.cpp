/// What gets into a solid is put back into the fluid, counted, or ends the run.
#include "LeakGuard.hpp"
#include "CaseError.hpp"
#include "Walls.hpp"
#include "offWalls.hpp"
#include "scenes.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace sph
{
namespace
{

using namespace test;

constexpr double spacing = 0.05;

/// A tank whose floor bears a block.
struct Guarded
{
    Geometry geometry = domain(2, {1, 1, 1});
    FieldStore<2> store;
    std::unique_ptr<Images<2>> images;
    std::unique_ptr<LeakGuard<2>> guard;

    Guarded(const std::vector<Vector<2>>& points, LeakAction action = LeakAction::putBack)
    {
        for (const auto& [at, n] : {std::pair{Vector<3>{0, 0, 0}, Vector<3>{1, 0, 0}},
                                    {Vector<3>{1, 0, 0}, Vector<3>{-1, 0, 0}},
                                    {Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}}})
            addWall(geometry, Plane(at, n));
        addWall(geometry, SolidBox({0.4, 0, -Box::infinity}, {0.6, 0.3, Box::infinity}));
        repeatPeriodically(geometry, 0.2);
        images = std::make_unique<Images<2>>(geometry, 0.2, spacing);
        guard = std::make_unique<LeakGuard<2>>(geometry, spacing, 3 * spacing, action);
        store.allocateState(Velocity{});
        store.allocateState(Mass{});
        setPositions(store, points);
        for (std::size_t i = 0; i < points.size(); ++i) store.component("m", 0)[i] = double(i + 1);
        for (double* v : store.pointers(Velocity{})) std::fill_n(v, points.size(), 1.0);
    }
    std::size_t keep(std::size_t n) { return (*guard)(store, n, *images); }
};

// Out of the block's side, at 0.02 spacings, without the velocity into it; not through the face on the floor, which is nearer.
TEST(LeakGuard, PutsBackThroughTheFaceThatBoundsTheFluid)
{
    Guarded scene({{0.41, 0.004}, {0.2, 0.5}});
    scene.keep(2);
    EXPECT_DOUBLE_EQ(positionOf(scene.store, 0).x, 0.4 - 0.02 * spacing);
    EXPECT_DOUBLE_EQ(positionOf(scene.store, 0).y, 0.004);
    EXPECT_EQ(scene.store.component("U", 0)[0], 0);
    EXPECT_EQ(scene.store.component("U", 1)[0], 1);
    EXPECT_EQ(positionOf(scene.store, 1), (Vector<2>{0.2, 0.5}));
    EXPECT_EQ(scene.guard->leaks().putBack, 1);
    EXPECT_NEAR(scene.guard->leaks().deepest, 0.01, 1e-15);
}

// A particle that only touches has not leaked, though it is put off the wall: 0.02 spacings either way.
TEST(LeakGuard, CountsWhatIsDeeperThanATouch)
{
    Guarded scene({{0.3, -0.0009}, {0.3, -0.0011}});
    scene.keep(2);
    EXPECT_EQ(scene.guard->leaks().putBack, 1);
    for (std::size_t i : {0u, 1u}) EXPECT_DOUBLE_EQ(positionOf(scene.store, i).y, 0.001);
}

// Along the floor inside the block, which is where particles once travelled without a message, and more than half a spacing deep anywhere.
TEST(LeakGuard, EndsTheRunWhereNoWayLeadsBack)
{
    for (const auto& x : {Vector<2>{0.5, 0.002}, Vector<2>{0.5, -0.002}, Vector<2>{0.3, -0.03}, Vector<2>{0.43, 0.1}})
    {
        Guarded scene({x});
        EXPECT_THROW(scene.keep(1), CaseError) << x.x << " " << x.y;
    }
}

// Deep in the corner of the block and the floor, behind both.
TEST(LeakGuard, PutsBackOutOfACorner)
{
    Guarded scene({{0.4006, -0.0019}});
    scene.keep(1);
    const auto x = positionOf(scene.store, 0);
    EXPECT_NEAR(x.x, 0.399, 1e-12);
    EXPECT_NEAR(x.y, 0.001, 1e-12);
}

// Off the floor and off the block at once; the walls that it was put off are told. In a slit narrower than twice the distance it stays between the two.
TEST(OffWalls, HoldsOffAllWallsInTurn)
{
    Guarded scene({{0.2, 0.5}});
    std::vector<Vector<2>> normals;
    const auto corner = offWalls(*scene.images, Vector<2>{0.399, 0.002}, 0.01, 0.025, [&](const Vector<2>& n) { normals.push_back(n); });
    EXPECT_NEAR(corner.x, 0.39, 1e-15);
    EXPECT_NEAR(corner.y, 0.01, 1e-15);
    EXPECT_EQ(normals, (std::vector<Vector<2>>{{-1, 0}, {0, 1}}));
    const Vector<2> free{0.38, 0.4};
    EXPECT_EQ(offWalls(*scene.images, free, 0.01, 0.025, [&](const Vector<2>&) { ADD_FAILURE(); }), free);

    addWall(scene.geometry, SolidBox({0.1, 0.004, -Box::infinity}, {0.3, 0.2, Box::infinity}));
    repeatPeriodically(scene.geometry, 0.2);
    const Images<2> withSlit(scene.geometry, 0.2, spacing);
    const auto between = offWalls(withSlit, Vector<2>{0.2, 0.003}, 0.003, 0.025, [](const Vector<2>&) {});
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

// Of the three within 0.06 m of the floor or of the block one is also near both, and is told once.
TEST(Images, NameTheParticlesThatAreNearTheirFaces)
{
    Guarded scene({{0.2, 0.5}, {0.2, 0.05}, {0.35, 0.05}, {0.36, 0.2}, {0.2, 0.07}});
    scene.images->build(scene.store, 5);
    const auto near = scene.images->nearFaces(0.06);
    ASSERT_EQ(near.size(), 3);
    const std::pair<std::size_t, double> expected[]{{1, 0.05}, {2, 0.05}, {3, 0.04}};
    for (std::size_t k = 0; k < 3; ++k)
    {
        EXPECT_EQ(near[k].first, expected[k].first);
        EXPECT_NEAR(near[k].second, expected[k].second, 1e-15);
    }
}

// However deep, and outside the domain: with its mass, 2 + 3 + 5 kg/m. Whoever only touches is put off the wall, the others stay with what they have.
TEST(LeakGuard, RemovesWhatHasLeakedWhereItIsToldTo)
{
    Guarded scene({{0.2, 0.5}, {0.41, 0.1}, {0.5, 0.1}, {0.3, -0.0009}, {0.3, 5}, {0.8, 0.5}}, LeakAction::remove);
    ASSERT_EQ(scene.keep(6), 3);
    EXPECT_EQ(scene.store.owned(), 3);
    const Vector<2> left[]{{0.2, 0.5}, {0.3, 0.001}, {0.8, 0.5}};
    const double masses[]{1, 4, 6};
    for (std::size_t i = 0; i < 3; ++i)
    {
        EXPECT_EQ(positionOf(scene.store, i), left[i]);
        EXPECT_EQ(scene.store.component("m", 0)[i], masses[i]);
    }
    const auto& leaks = scene.guard->leaks();
    EXPECT_EQ(leaks.removed, 3);
    EXPECT_EQ(leaks.removedMass, 10);
    EXPECT_EQ(leaks.putBack, 0);
    EXPECT_NEAR(leaks.deepest, 0.1, 1e-15);
    EXPECT_EQ(leaks.at, (Vector<3>{0.5, 0.1, 0}));
    EXPECT_EQ(wallInWords(scene.geometry, leaks.patch, leaks.at), "\"wall3\"");

    Guarded nowhere({{0.2, 0.5}, {std::nan(""), 0.5}}, LeakAction::remove);
    EXPECT_THROW(nowhere.keep(2), CaseError) << "a place that is no number is the end of a solution, not a leak";
}

TEST(LeakGuard, StopsAtTheFirstLeakWhereItIsToldTo)
{
    Guarded touching({{0.3, -0.0009}}, LeakAction::stop), leaking({{0.3, 0.5}, {0.3, -0.002}}, LeakAction::stop);
    EXPECT_NO_THROW(touching.keep(1));
    try
    {
        leaking.keep(2);
        FAIL();
    }
    catch (const CaseError& e)
    {
        for (const char* word : {"particle 1", "(0.3 -0.002 0)", "0.002 m beyond a wall \"wall2\"", "leakedParticles stop"})
            EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
    }
}

}
}
