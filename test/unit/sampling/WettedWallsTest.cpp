#include "sampling/WettedWalls.hpp"
#include "Particles.hpp"
#include "geometry/PatchTree.hpp"
#include "geometry/Plane.hpp"
#include "geometry/SolidBox.hpp"
#include "geometry/Sphere.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>

using namespace sph;

namespace
{

void addWall(Geometry& g, std::shared_ptr<const Shape> shape)
{
    g.patches.push_back({std::move(shape), int(g.walls.size())});
    g.walls.emplace_back();
    g.walls.back().name = "wall" + std::to_string(g.walls.size());
}

/// Water below `level` around a sphere of radius 0.3 in the middle of a cube, with gas above or nothing.
std::vector<WettedWall> aroundASphere(double level, bool gas, double dx)
{
    const Vector<3> low{-0.35, -0.35, -0.35}, high{0.35, 0.35, 0.35};
    const Sphere sphere({0, 0, 0}, 0.3, FluidSide::outside);
    const Particles lattice(3, low, high, dx);
    Particles particles(3, low, low, dx);
    particles.geometry = lattice.geometry;
    if (gas) particles.phases = {"water", "air"};
    for (std::size_t i = 0; i < lattice.size(); ++i)
        if (const auto x = lattice.position(i); sphere.foot(x).distance > 0 && (gas || x.y < level)) particles.add(x);
    if (gas) particles.setPhase([&](Vector<3> x) { return x.y < level ? 0 : 1; });
    addWall(particles.geometry, std::make_shared<Sphere>(sphere));
    return WettedWalls(particles.view(), {low, high})(particles.view(), 0);
}

}

// Water to 0.4 of a box of 1 x 1 x 1 with gas above: the floor is wet, four tenths of each side, nothing of the lid; alike without the gas. What is off is
// the particles' staircase at an edge: 1 % of a side at 20 spacings.
TEST(WettedWalls, ofABox)
{
    for (const bool gas : {true, false})
    {
        Particles particles(3, {0, 0, 0}, {1, gas ? 1.0 : 0.4, 1}, 0.05);
        particles.geometry.high.y = 1;
        if (gas)
        {
            particles.phases = {"water", "air"};
            particles.setPhase([](Vector<3> x) { return x.y < 0.4 ? 0 : 1; });
        }
        auto& g = particles.geometry;
        addWall(g, std::make_shared<Plane>(Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}));
        addWall(g, std::make_shared<Plane>(Vector<3>{0, 0, 0}, Vector<3>{1, 0, 0}));
        addWall(g, std::make_shared<Plane>(Vector<3>{0, 0, 1}, Vector<3>{0, 0, -1}));
        addWall(g, std::make_shared<Plane>(Vector<3>{0, 1, 0}, Vector<3>{0, -1, 0}));
        const auto walls = WettedWalls(particles.view(), {g.low, g.high})(particles.view(), 0);
        const double share[] = {1, 0.4, 0.4, 0};
        for (std::size_t w = 0; w < 4; ++w)
        {
            EXPECT_NEAR(walls[w].area, 1, 1e-12);
            EXPECT_NEAR(walls[w].wetted, share[w], 0.01) << w << gas;
        }
    }
}

// A sphere in water to its equator, and to a quarter of its height, where the surface meets it at 60 degrees: the wetted share is that of the cap, whether
// there is gas above or nothing. 6, 12 and 24 spacings to the radius: errors of the share are 0, 0, 0 and -0.6, 0.2, 0.1 % with gas, 0.4, 0.3, 0.05 and
// 2.5, 1.5, 0.75 % without. They fall with the spacing.
TEST(WettedWalls, ofASphereConvergeToThatOfTheCap)
{
    const double R = 0.3, all = 4 * std::numbers::pi * R * R;
    for (const double level : {0.0, -0.15})
        for (const bool gas : {true, false})
        {
            const double cap = (R + level) / (2 * R);
            std::vector<double> errors;
            for (const double dx : {0.05, 0.025, 0.0125})
            {
                const auto wall = aroundASphere(level, gas, dx).at(0);
                EXPECT_NEAR(wall.area, all, 2e-3 * all);
                errors.push_back(std::abs(wall.share() - cap));
            }
            SCOPED_TRACE(fmt::format("level {}, {} gas", level, gas ? "with" : "without"));
            EXPECT_LE(errors[0], gas ? 0.01 : 0.03);
            EXPECT_LE(errors[2], 0.5 * errors[0]);
            EXPECT_LE(errors[2], gas ? 2e-3 : 0.01);
        }
}

// A block that stands on a floor: the floor below it is no wall, nor is its lower side. Edges are those of triangles, half a spacing long.
TEST(WettedWalls, leaveOutWhatAnotherSolidCovers)
{
    Particles particles(3, {0, 0, 0}, {1, 1, 1}, 0.05);
    auto& g = particles.geometry;
    addWall(g, std::make_shared<Plane>(Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}));
    addWall(g, std::make_shared<SolidBox>(Vector<3>{0.3, 0, 0.3}, Vector<3>{0.7, 0.4, 0.7}));
    const auto walls = WettedWalls(particles.view(), {g.low, g.high})(particles.view(), 0);
    EXPECT_NEAR(walls[0].area, 1 - 0.16, 0.02);
    EXPECT_NEAR(walls[1].area, 0.16 + 4 * 0.16, 0.02);
}

// Water that falls from 0.8 to the equator of a sphere in a box, and a floor that then rises by 0.25 into the sphere: walls that were made before the water
// fell give the same numbers to the bit as walls made anew, also where the floor has moved.
TEST(WettedWalls, areMadeOnceAndAgainWhereOneHasMoved)
{
    const Box box{{0, 0, 0}, {1, 1, 1}};
    const auto sphere = std::make_shared<Sphere>(Vector<3>{0.5, 0.4, 0.5}, 0.3, FluidSide::outside);
    Geometry g = Particles(3, box.low, box.high, 1).geometry;
    addWall(g, std::make_shared<Plane>(box.low, Vector<3>{0, 1, 0}));
    addWall(g, sphere);
    const auto below = [&](double level)
    {
        const Particles lattice(3, box.low, {1, level, 1}, 0.05);
        Particles particles(3, box.low, box.low, 0.05);
        for (std::size_t i = 0; i < lattice.size(); ++i)
            if (sphere->foot(lattice.position(i)).distance > 0) particles.add(lattice.position(i));
        particles.geometry = g;
        return particles;
    };
    const auto full = below(0.8);
    auto half = below(0.4);
    WettedWalls kept(full.view(), box);
    const auto wallsOf = [&](const Particles& particles)
    {
        const auto walls = kept(particles.view(), 0), anew = WettedWalls(particles.view(), box)(particles.view(), 0);
        for (std::size_t w = 0; w < 2; ++w)
        {
            EXPECT_EQ(walls.at(w).area, anew.at(w).area) << w;
            EXPECT_EQ(walls.at(w).wetted, anew.at(w).wetted) << w;
        }
        return walls;
    };
    EXPECT_NEAR(wallsOf(full)[1].share(), 1, 0.01);
    EXPECT_NEAR(wallsOf(half)[1].share(), 0.5, 0.02);
    EXPECT_NEAR(wallsOf(half)[0].area, 1, 1e-12);
    half.geometry.patches[0].shape = half.geometry.patches[0].shape->shifted({0, 0.25, 0});
    EXPECT_NEAR(wallsOf(half)[0].area, 1 - std::numbers::pi * (0.3 * 0.3 - 0.15 * 0.15), 0.02);
}
