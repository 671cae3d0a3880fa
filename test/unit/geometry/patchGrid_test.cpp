#include "geometry/PatchGrid.hpp"
#include "reading.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

using namespace sph;
using namespace sph::test;

namespace
{

/// Every patch within reach is found, and the smallest distance is that of all patches, near and far.
void expectComplete(const Geometry& g, double mostPatchesPerPoint)
{
    std::mt19937 random(11);
    std::uniform_real_distribution<double> u(0, 1);
    double listed = 0;
    const int points = 2000;
    for (int i = 0; i < points; ++i)
    {
        // Over the domain extended by the reach.
        const auto at = [&](double low, double high) { return low - g.reach + u(random) * (high - low + 2 * g.reach); };
        const Vector<3> x{at(g.low.x, g.high.x), at(g.low.y, g.high.y), at(g.low.z, g.high.z)};
        const auto near = g.grid->near(x);
        listed += double(near.size());
        EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
        double smallest = Box::infinity, overAllShifts = Box::infinity;
        for (int p = 0; p < int(g.patches.size()); ++p)
        {
            const double d = g.patches[p].shape->foot(x).distance;
            smallest = std::min(smallest, d);
            if (d <= g.reach) { ASSERT_TRUE(std::binary_search(near.begin(), near.end(), p)) << p << " at distance " << d; }
        }
        if (smallest <= g.reach) { EXPECT_EQ(g.distance(x), smallest); }
        // Far from the walls the tree must agree with all patches and their shifts.
        for (int a = -1; a <= 1; ++a)
            for (int b = -1; b <= 1; ++b)
                for (int c = -1; c <= 1; ++c)
                {
                    if ((a != 0 && !g.periodic[0]) || (b != 0 && !g.periodic[1]) || (c != 0 && !g.periodic[2]) || smallest <= g.reach)
                        continue;
                    const Vector<3> shifted = x + Vector<3>{a * g.length(0), b * g.length(1), c * g.length(2)};
                    for (const auto& p : g.patches) overAllShifts = std::min(overAllShifts, p.shape->foot(shifted).distance);
                }
        if (smallest > g.reach) { EXPECT_EQ(g.distance(x), overAllShifts); }
    }
    EXPECT_LT(listed / points, mostPatchesPerPoint);
}

}

// Against all patches, for a bed of 128 + copies and for 200 random spheres and a tilted plane; and the lists stay short.
TEST(PatchGrid, findsWhatASearchOverAllPatchesFinds)
{
    const auto bed = read(cube + "walls { grains { type sphereBed; lattice bcc; radius 0.1; period 0.25; } }", 0.04).geometry;
    EXPECT_EQ(bed.originals.size(), 128u);
    expectComplete(bed, 4);

    std::mt19937 random(2);
    std::uniform_real_distribution<double> u(0, 1);
    std::string list;
    for (int i = 0; i < 200; ++i)
        list += "(" + std::to_string(u(random)) + " " + std::to_string(u(random)) + " " + std::to_string(u(random)) + " " +
                std::to_string(0.02 + 0.05 * u(random)) + ") ";
    const auto [spheres, errors] =
        read("dimension 3; domain { min (0 0 0); max (1 1 1); periodic (x y); }\nwalls { grains { type spheres; spheres (" + list +
                 "); } floor { type plane; point (0 0 0); normal (0 0 1); } }",
             0.05);
    EXPECT_EQ(errors, "");
    expectComplete(spheres, 8);
}

// Positions of 2-D scenes have z = 0, wherever the domain's unused z range lies.
TEST(PatchGrid, worksIn2D)
{
    const auto [g, errors] = read("dimension 2; domain { min (0 0 3); max (1 1 4); periodic (x); }\n"
                                  "walls { a { type sphere; centre (0 0.5 0); radius 0.2; fluid outside; }"
                                  " b { type plane; point (0 0 0); normal (0 1 0); } }",
                                  0.1);
    EXPECT_EQ(errors, "");
    EXPECT_EQ(g.patches.size(), 3u);
    EXPECT_EQ(g.grid->near({0.5, 0.05, 0}).size(), 1u);
    EXPECT_NEAR(g.distance({0.95, 0.75, 0}), std::hypot(0.05, 0.25) - 0.2, 1e-15);
}
