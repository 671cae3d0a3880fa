/// What gets into a solid is put back into the fluid, counted, or ends the run.
#include "scene/LeakGuard.hpp"
#include "base/CaseError.hpp"
#include "geometry/Walls.hpp"
#include "scenes.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace sph
{
namespace
{

using namespace test;

constexpr double spacing = 0.05;

struct Guarded
{
    Geometry geometry = tankWithBlock();
    FieldStore<2> store;
    std::unique_ptr<NearWalls> walls;
    std::unique_ptr<LeakGuard<2>> guard;

    Guarded(const std::vector<Vector<2>>& points, LeakAction action = LeakAction::putBack)
    {
        walls = std::make_unique<NearWalls>(geometry, 0.2);
        guard = std::make_unique<LeakGuard<2>>(geometry, spacing, 3 * spacing, action);
        store.allocateState(Velocity{});
        store.allocateState(Mass{});
        setPositions(store, points);
        for (std::size_t i = 0; i < points.size(); ++i) store.component("m", 0)[i] = double(i + 1);
        for (double* v : store.pointers(Velocity{})) std::fill_n(v, points.size(), 1.0);
    }
    std::size_t keep(std::size_t n) { return (*guard)(store, n, *walls); }
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
