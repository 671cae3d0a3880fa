/// Shares of images among two walls, by their formulas: halves on the bisector, all of it with one of the two, nothing in a gap. Round-off.
#include "images/imageShares.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace sph
{
namespace
{

constexpr double spacing = 0.1;

Vector<3> turned(double degrees)
{
    const double angle = degrees * std::numbers::pi / 180;
    return {std::sin(angle), std::cos(angle), 0};
}

// Two faces of which either image lies at its own depth: the two shares are one at any depths, and halves where the depths are the same.
TEST(ImageShares, BesideOneAnotherAreOne)
{
    const Vector<3> n = turned(0);
    for (const double degrees : {80.0, 120.0, 160.0})
        for (const double h : {0.05, 0.1, 0.11, 0.3})
        {
            const double k = 0.1, share = shareBeside(n, h, turned(degrees), k, spacing),
                         other = shareBeside(turned(degrees), k, n, h, spacing);
            EXPECT_NEAR(share + other, 1, 1e-14) << degrees << ' ' << h;
            EXPECT_EQ(share == 0.5, h == k);
            if (h > 2 * k) { EXPECT_EQ(share, 1); }
        }
}

// Surfaces at a fluid angle of 120 degrees or more fill the solid with one reflection each.
TEST(ImageShares, EndWhereOneReflectionEachFillsTheSolid)
{
    EXPECT_EQ(shareBeside(turned(0), 0.1, turned(59), 0.05, spacing), 0);
    EXPECT_EQ(shareBeside(turned(0), 0.2, turned(76), 0.05, spacing), 1);
}

// All of what is mirrored again in a wedge of 20 degrees, nothing in a gap of 8.
TEST(ImageShares, FadeFromAWedgeToAGap)
{
    EXPECT_EQ(shareOfWedge(turned(0), turned(180 - 20.1)), 1);
    EXPECT_EQ(shareOfWedge(turned(0), turned(180 - 8)), 0);
    const double between = shareOfWedge(turned(0), turned(180 - 14));
    EXPECT_GT(between, 0);
    EXPECT_LT(between, 1);
    EXPECT_GT(shareOfWedge(turned(0), turned(180 - 14), 0.005), between); // where the normals may turn apart
}

}
}
