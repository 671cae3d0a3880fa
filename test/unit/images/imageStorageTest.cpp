/// Images: how they move with their sources, which of them are kept, and what they tell of the walls near.
#include "Imaged.hpp"
#include "neighbours/NeighbourLists.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace sph
{
namespace
{

using namespace test;

// Inside a circle of radius R a particle's image moves (R + d)/(R - d) times as far along the wall as the particle; the images say so, and
// nothing of the kind where walls are plane or convex.
TEST(Images, TellHowFastTheyMove)
{
    const double R = 1, d = 0.3, skin = 0.1;
    Geometry disc = domain(2, {1, 1, 0});
    disc.low = {-1, -1, 0};
    addWall(disc, Cylinder({0, 0, 0}, {0, 0, 1}, R, FluidSide::inside));
    repeatPeriodically(disc, 0.5);
    FieldStore<2> store;
    Images<2> images(disc, 0.5, 0.1, skin);
    images.rules().set(Velocity{}, std::make_unique<Reversed<2>>());
    setPositions<2>(store, {{R - d, 0}});
    images.build(store, 1);
    const auto before = positionOf(store, 1);
    const double angle = 1e-3;
    store.component(Position::info.name, 0)[0] = (R - d) * std::cos(angle);
    store.component(Position::info.name, 1)[0] = (R - d) * std::sin(angle);
    images.move(store);
    const double factor = mag(positionOf(store, 1) - before) / (2 * (R - d) * std::sin(0.5 * angle));
    EXPECT_NEAR(factor, (R + d) / (R - d), 1e-9);
    EXPECT_GE(images.closingSpeed(), 0.5 * (1 + factor));
    EXPECT_NEAR(images.closingSpeed(), 0.5 * (1 + (R + d + 0.5 * skin) / (R - d - 0.5 * skin)), 1e-12);

    Imaged<2> plane(cornerOfBox(2), 0.3, {{0.1, 0.15}});
    EXPECT_EQ(plane.images.closingSpeed(), 1);
    Geometry ball = domain(2, {1, 1, 0});
    addWall(ball, Cylinder({0.5, 0.5, 0}, {0, 0, 1}, 0.3, FluidSide::outside));
    Imaged<2> convex(ball, 0.2, {{0.1, 0.5}});
    EXPECT_EQ(convex.images.count(), 1u);
    EXPECT_EQ(convex.images.closingSpeed(), 1);
}

// The walls near a particle in a corner are two, although it has a third image; each once, with foot, normal and wall, and never again for its
// periodic copies.
TEST(Images, TellEachWallNearOnce)
{
    Geometry g = domain(2, {1, 1, 0}, {true, false, false});
    addWall(g, Plane({0, 0, 0}, {0, 1, 0}));
    addWall(g, Plane({0, 1, 0}, {0, -1, 0}));
    const auto points = randomPoints<2>(300, {1, 1});
    Imaged<2> channel(g, 0.6, points, 0.05);
    for (const auto& x : points)
    {
        std::vector<int> walls;
        channel.images.nearWalls().forEachFoot(in3D(x), Box::infinity,
                                               [&](const Foot& foot, const Patch& patch)
                                               {
                                                   if (foot.distance > 0.6)
                                                       return; // within reach of some particles of its cell, not of this
                                                   walls.push_back(patch.wall);
                                                   EXPECT_NEAR(foot.distance, patch.wall == 0 ? x.y : 1 - x.y, 1e-15);
                                                   EXPECT_EQ(foot.normal.y, patch.wall == 0 ? 1 : -1);
                                                   EXPECT_EQ(foot.exposure, 1);
                                               });
        std::sort(walls.begin(), walls.end());
        std::vector<int> expected;
        if (x.y <= 0.6) expected.push_back(0);
        if (x.y >= 0.4) expected.push_back(1);
        EXPECT_EQ(walls, expected) << x.x << ' ' << x.y;
    }

    Imaged<2> corner(cornerOfBox(2), 0.3, {{0.1, 0.15}});
    int told = 0;
    corner.images.nearWalls().forEachFoot({0.1, 0.15, 0}, Box::infinity,
                                          [&](const Foot& foot, const Patch& patch)
                                          {
                                              ++told;
                                              EXPECT_NEAR(foot.distance, patch.wall == 0 ? 0.1 : 0.15, 1e-15);
                                          });
    EXPECT_EQ(told, 2);
}

// After the particles have moved, move() gives what build() would, as long as the same images exist.
TEST(Images, MoveWithTheirSources)
{
    Geometry ball = domain(2, {1, 1, 0}, {true, false, false});
    addWall(ball, Cylinder({0.5, 0.5, 0}, {0, 0, 1}, 0.3, FluidSide::outside));
    std::vector<Vector<2>> points{{0.5, 0.85}, {0.05, 0.5}, {0.9, 0.9}};
    Imaged<2> scene(ball, 0.25, points);
    for (auto& p : points) p += Vector<2>{0.01, 0.005};
    for (std::size_t i = 0; i < points.size(); ++i)
        sph::store(points[i], [&](int c, double q) { scene.store.component("positions", c)[i] = q; });
    scene.images.move(scene.store);
    Imaged<2> afresh(ball, 0.25, points);
    ASSERT_EQ(scene.images.count(), afresh.images.count());
    for (std::size_t k = 0; k <= scene.images.nullParticle(); ++k)
    {
        EXPECT_EQ(positionOf(scene.store, k).x, positionOf(afresh.store, k).x);
        EXPECT_EQ(positionOf(scene.store, k).y, positionOf(afresh.store, k).y);
        EXPECT_EQ(scene.store.component("volumeFactor", 0)[k], afresh.store.component("volumeFactor", 0)[k]);
    }
}

// Images that no list names are forgotten: the others follow one another in the arrays, in the same order, and are where they were, at once and when they are moved.
TEST(Images, ThatNobodySeesAreForgotten)
{
    Geometry ball = domain(2, {1, 1, 0}, {true, false, false});
    addWall(ball, Cylinder({0.5, 0.5, 0}, {0, 0, 1}, 0.3, FluidSide::outside));
    std::vector<Vector<2>> points;
    for (int k = 0; k < 400; ++k)
        if (const Vector<2> p{std::fmod(0.5 + k * 0.7548776662, 1.0), std::fmod(0.5 + k * 0.5698402910, 1.0)};
            mag(p - Vector<2>{0.5, 0.5}) > 0.3)
            points.push_back(p);
    const double reach = 0.2;
    Imaged<2> all(ball, reach, points), seen(ball, reach, points);
    NeighbourLists<2> listsOfAll, lists;
    for (auto& [scene, of] : {std::pair(&all, &listsOfAll), std::pair(&seen, &lists)})
        of->build(std::as_const(scene->store).pointers(Position{}), points.size(), scene->images.nullParticle(), reach);
    seen.images.keepSeen(seen.store, lists);
    EXPECT_LT(seen.images.count(), 0.9 * double(all.images.count()));
    EXPECT_EQ(seen.store.size(), points.size() + seen.images.count() + 1);
    const auto holdsTheSame = [&]
    {
        std::map<int, int> placeOf; // of each that is named, by where it was
        NeighbourLists<2>::Room roomOfAll, room;
        for (std::size_t i = 0; i < points.size(); ++i)
        {
            const auto before = listsOfAll.of(i, roomOfAll), now = lists.of(i, room);
            ASSERT_EQ(before.size(), now.size()) << i;
            for (std::size_t t = 0; t < now.size(); ++t)
                ASSERT_EQ(placeOf.try_emplace(before[t], now[t]).first->second, now[t]) << "particle " << i;
        }
        int last = -1;
        for (const auto& [before, now] : placeOf)
        {
            EXPECT_EQ(now, last + 1); // all of the places, in order: each owned particle is in its own list
            last = now;
            EXPECT_EQ(mag(positionOf(seen.store, std::size_t(now)) - positionOf(all.store, std::size_t(before))), 0) << before;
            EXPECT_EQ(seen.store.component("volumeFactor", 0)[now], all.store.component("volumeFactor", 0)[before]) << before;
        }
        EXPECT_EQ(last, int(seen.images.nullParticle()));
    };
    holdsTheSame();
    for (auto* scene : {&all, &seen})
    {
        for (std::size_t i = 0; i < points.size(); ++i) scene->store.component("positions", 1)[i] += 1e-3;
        scene->images.move(scene->store);
    }
    holdsTheSame();
}

// Fields other than places get room for the images that are seen alone.
TEST(Images, ThatNobodySeesTakeNoRoom)
{
    Imaged<2> scene(cornerOfBox(2), 0.2, randomPoints<2>(300, {1, 1}));
    scene.store.allocate(Pressure{});
    scene.images.buildPlaces(scene.store, 300);
    const std::size_t all = scene.images.count();
    NeighbourLists<2> lists;
    lists.build(std::as_const(scene.store).pointers(Position{}), 300, scene.images.nullParticle(), 0.1);
    scene.images.keepSeen(scene.store, lists);
    ASSERT_LT(scene.images.count(), 0.8 * double(all));
    EXPECT_EQ(scene.store.fields().at("p").component[0].size(), 301 + scene.images.count());
}

// Of the three within 0.06 m of the floor or of the block one is also near both, and is told once.
TEST(Images, NameTheParticlesThatAreNearTheirFaces)
{
    Imaged<2> scene(tankWithBlock(), 0.2, {{0.2, 0.5}, {0.2, 0.05}, {0.35, 0.05}, {0.36, 0.2}, {0.2, 0.07}}, 0.05);
    const auto near = scene.images.nearFaces(0.06);
    ASSERT_EQ(near.size(), 3);
    const std::pair<std::size_t, double> expected[]{{1, 0.05}, {2, 0.05}, {3, 0.04}};
    for (std::size_t k = 0; k < 3; ++k)
    {
        EXPECT_EQ(near[k].first, expected[k].first);
        EXPECT_NEAR(near[k].second, expected[k].second, 1e-15);
    }
}

}
}
