/// Walls around a point: what the grid and the tree give is what a plain loop over all patches gives.
#include "geometry/forEachFoot.hpp"
#include "reading.hpp"
#include <gtest/gtest.h>
#include <random>
#include <utility>

using namespace sph;
using namespace sph::test;

namespace
{

/// The first of the patches that are as near, by a loop over all.
void expectThatOfALoop(const Geometry& g, const Vector<3>& x)
{
    int nearest = -1, second = -1;
    double distance = Box::infinity, toSecond = Box::infinity;
    std::vector<int> within, found;
    for (int p = 0; p < int(g.patches.size()); ++p)
    {
        const double d = g.patches[std::size_t(p)].shape->foot(x).distance;
        if (d <= g.reach) within.push_back(p);
        if (d < distance)
        {
            toSecond = std::exchange(distance, d);
            second = std::exchange(nearest, p);
        }
        else if (d < toSecond)
        {
            toSecond = d;
            second = p;
        }
    }
    const auto [foot, patch] = nearestFoot(g, x);
    EXPECT_EQ(patch, nearest) << x.x << " " << x.y << " " << x.z;
    EXPECT_EQ(foot.distance, distance);
    if (nearest >= 0) { EXPECT_EQ(foot.normal, g.patches[std::size_t(nearest)].shape->foot(x).normal); }
    EXPECT_EQ(nearestFoot(g, x, nearest).patch, second) << x.x << " " << x.y << " " << x.z;
    forEachFootAlone(g, x, g.reach, [&](const Foot&, int p) { found.push_back(p); });
    EXPECT_EQ(found, within);
}

/// With grid and tree, and as they are made by hand, without.
void expectThatOfALoop(const Geometry& g, const std::vector<Vector<3>>& places)
{
    auto byHand = g;
    byHand.grid = nullptr;
    byHand.tree = nullptr;
    for (const auto& x : places)
    {
        expectThatOfALoop(g, x);
        expectThatOfALoop(byHand, x);
    }
}

}

// 200 overlapping spheres and a plane, from places in the fluid, in one solid and in several, and outside of the domain. All to the bit.
TEST(NearestFoot, IsThatOfALoopOverARandomBed)
{
    std::mt19937 random(5);
    std::uniform_real_distribution<double> u(0, 1), wide(-0.3, 1.3);
    std::string list;
    for (int i = 0; i < 200; ++i)
        list += "(" + std::to_string(u(random)) + " " + std::to_string(u(random)) + " " + std::to_string(u(random)) + " " +
                std::to_string(0.02 + 0.05 * u(random)) + ") ";
    const auto [g, errors] =
        read("dimension 3; domain { min (0 0 0); max (1 1 1); periodic (x y); }\nwalls { grains { type spheres; spheres (" + list +
                 "); } floor { type plane; point (0 0 0); normal (0 0 1); } }",
             0.05);
    EXPECT_EQ(errors, "");
    std::vector<Vector<3>> places;
    int inSolid = 0;
    for (int i = 0; i < 3000; ++i)
    {
        places.push_back({wide(random), wide(random), wide(random)});
        inSolid += g.distance(places.back()) < 0;
    }
    EXPECT_GT(inSolid, 100);
    expectThatOfALoop(g, places);
}

// Numbers of few bits, so that the distances to spheres on either side are equal to the bit: the first patch is the nearest, as in the loop.
TEST(NearestFoot, IsTheFirstOfSeveralAsNear)
{
    const auto [g, errors] = read(cube + "walls { grains { type sphereBed; lattice sc; radius 0.0625; period 0.25; } }", 0.05);
    EXPECT_EQ(errors, "");
    std::vector<Vector<3>> places;
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 8; ++k)
            for (int l = 0; l < 8; ++l) places.push_back({i / 8.0, k / 8.0, l / 8.0});
    expectThatOfALoop(g, places);
}

TEST(NearestFoot, IsNoneWithoutWallsAndOfNoPlace)
{
    auto [g, errors] = read(cube + "walls { grains { type sphereBed; lattice sc; radius 0.1; period 0.5; } }", 0.05);
    EXPECT_EQ(nearestFoot(g, {std::nan(""), 0.1, 0.1}).patch, -1);
    EXPECT_EQ(nearestFoot(g, {std::nan(""), 0.1, 0.1}).foot.distance, Box::infinity);
    g = read(cube).geometry;
    EXPECT_EQ(nearestFoot(g, {0.1, 0.1, 0.1}).patch, -1);
    EXPECT_EQ(nearestFoot(g, {0.1, 0.1, 0.1}).foot.distance, Box::infinity);
}
