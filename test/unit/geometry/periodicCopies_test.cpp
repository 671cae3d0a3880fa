#include "geometry/Sphere.hpp"
#include "geometry/TriangleMesh.hpp"
#include "meshes.hpp"
#include "reading.hpp"
#include <gtest/gtest.h>
#include <set>

using namespace sph;
using namespace sph::test;

// bcc, radius 0.3, period 1, reach 0.1: the 8 corners and the centre touch the domain, and the 6 neighbouring centres are 0.5 -
// 0.3 away from it, beyond the reach: 9. With reach 0.25 they count: 15. A reach of 0.71 adds the corners next to the domain's
// (1 - 0.3 = 0.7 off a corner): each of 8 corners has 3, 24 more; and the centres across edges, sqrt(0.5) - 0.3 = 0.41: 12
// more, and across corners, sqrt(0.75) - 0.3 = 0.566: 8 more.
TEST(PeriodicCopies, ofABccBedAreMadeOnceEach)
{
    for (const auto& [reach, expected] : {std::pair{0.1, 9u}, std::pair{0.25, 15u}, std::pair{0.71, 15u + 24 + 12 + 8}})
    {
        const auto [g, errors] = read(bcc("1"), reach);
        EXPECT_EQ(errors, "");
        EXPECT_EQ(g.originals.size(), 2u);
        EXPECT_EQ(g.patches.size(), expected) << reach;
        std::set<std::array<long, 3>> centres;
        for (const auto& p : g.patches)
        {
            const auto c = dynamic_cast<const Sphere&>(*p.shape).centre();
            centres.insert({std::lround(2 * c.x), std::lround(2 * c.y), std::lround(2 * c.z)});
        }
        EXPECT_EQ(centres.size(), expected);
    }
}

// The same spheres written out by hand with some on both sides of the domain are not doubled.
TEST(PeriodicCopies, ofSpheresGivenTwiceAreOne)
{
    const auto [g, errors] =
        read(cube + "walls { grains { type spheres; spheres ((0 0 0 0.3) (1 1 0 0.3) (1 1 1 0.3) (0.5 0.5 0.5 0.3)); } }");
    EXPECT_EQ(errors, "");
    EXPECT_EQ(g.patches.size(), 9u);
}

// A mesh that has been continued through the domain stays one body along it (src/meshes, continuePeriodically), and repeats across: a bar from -1 to 2 of a period 1, beside a face of the other direction.
TEST(PeriodicCopies, ofWhatGoesOnThroughAreNone)
{
    Geometry g;
    g.high = {1, 1, 1};
    g.periodic = {true, true, false};
    g.walls.resize(1);
    for (const auto& body : bodiesOf(ofOneRegion(block({-1, 0.05, 0.4}, {2, 0.25, 0.6})), {0.05, 0.15}))
        g.originals.push_back({std::make_shared<TriangleMesh>(body), 0});
    repeatPeriodically(g, 0.2);
    ASSERT_EQ(g.patches.size(), 2u);
    for (const double x : {0.0, 0.5, 1.0})
    {
        EXPECT_NEAR(g.distance({x, 0.35, 0.5}), 0.1, 1e-12);
        EXPECT_NEAR(g.distance({x, 0.95, 0.5}), 0.1, 1e-12);
    }
}

// Grains that were united to one mesh stick out of both sides of their domain and end there: they repeat as a body. Of this one, two pyramids on a common base, the copies' tips lie beside it in the domain.
TEST(PeriodicCopies, ofABodyThatSticksOutOfBothSidesAreMade)
{
    Geometry g;
    g.high = {1, 1, 1};
    g.periodic = {true, false, false};
    g.walls.resize(1);
    TriangleSurface body;
    body.points = {{-0.2, 0.3, 0.5}, {1.2, 0.7, 0.5}, {0.5, 0.8, 0.5}, {0.5, 0.5, 0.8}, {0.5, 0.2, 0.5}, {0.5, 0.5, 0.2}};
    for (const auto& [a, b] : {std::pair{2, 3}, {3, 4}, {4, 5}, {5, 2}})
    {
        body.triangles.push_back({1, a, b});
        body.triangles.push_back({0, b, a});
    }
    for (const auto& of : bodiesOf(ofOneRegion(body), {0.05, 0.1})) g.originals.push_back({std::make_shared<TriangleMesh>(of), 0});
    repeatPeriodically(g, 0.1);
    EXPECT_EQ(g.patches.size(), 3u);
    // At x = 0.15 the tip at 0.2 is 0.7 - 0.014 high and 0.021 wide, the body itself reaches up to 0.55.
    EXPECT_FALSE(g.inFluid({0.15, 0.686, 0.5}));
    EXPECT_FALSE(g.inFluid({0.85, 0.314, 0.5}));
    EXPECT_TRUE(g.inFluid({0.15, 0.62, 0.5}));
    EXPECT_TRUE(g.inFluid({0.25, 0.7, 0.5}));
}

// The lattice must fit the domain; rounding of its length in the dictionary (1e-7) is taken out.
TEST(SphereBed, mustAgreeWithThePeriodicDomain)
{
    EXPECT_NE(read(bcc("0.45"))
                  .errors.find("the domain repeats in x after 1 m, which is not a whole number of cells of the bcc lattice "
                               "(0.45 m each): make it 0.9 m"),
              std::string::npos)
        << read(bcc("0.45")).errors;
    EXPECT_EQ(read(bcc("0.50000001")).errors, "");
    EXPECT_EQ(read(bcc("0.50000001")).geometry.originals.size(), 16u);
}

// Neighbours in the lattices: nearest distance and coordination number of crystallography.
TEST(SphereBed, latticesHaveTheirCoordinationNumbers)
{
    for (const auto& [name, neighbours, distance, perCell] :
         {std::tuple{"sc", 6, 1.0, 1u}, {"bcc", 8, std::sqrt(0.75), 2u}, {"fcc", 12, std::sqrt(0.5), 4u}, {"hcp", 12, 1.0, 4u}})
    {
        const auto lattice = sphereLattice(name, 1);
        EXPECT_EQ(lattice.centres.size(), perCell);
        for (const auto& a : lattice.centres)
        {
            int count = 0;
            for (const auto& b : lattice.centres)
                for (int i = -1; i <= 1; ++i)
                    for (int k = -1; k <= 1; ++k)
                        for (int l = -1; l <= 1; ++l)
                        {
                            const double r = mag(b - a + Vector<3>{i * lattice.period.x, k * lattice.period.y, l * lattice.period.z});
                            EXPECT_TRUE(r == 0 || r > distance - 1e-12) << name;
                            count += std::abs(r - distance) < 1e-12;
                        }
            EXPECT_EQ(count, neighbours) << name;
        }
    }
}

// Distance far from every copy within reach: the nearest sphere is across the boundary, 0.2 - 0.05 away.
TEST(Geometry, distanceSeesCopiesBeyondTheReach)
{
    const auto [g, errors] = read(cube + "walls { grain { type sphere; centre (0.1 0.5 0.5); radius 0.03; fluid outside; } }", 0.01);
    EXPECT_EQ(g.patches.size(), 1u);
    EXPECT_NEAR(g.distance({0.9, 0.5, 0.5}), 0.17, 1e-15);
}
