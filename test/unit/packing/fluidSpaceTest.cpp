#include "packing/FluidSpace.hpp"
#include "handMadeGeometry.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace sph;

// Box minus balls, exact to round-off; periodic copies of a ball on the corner count once.
TEST(FluidVolume, isExactForABoxAroundBalls)
{
    Geometry g = emptyBox(3, {1, 1, 1}, {true, true, true});
    add(g, Sphere({0, 0, 0}, 0.3, FluidSide::outside));
    add(g, Sphere({0.5, 0.5, 0.5}, 0.4, FluidSide::outside));
    repeatPeriodically(g, 0.3);
    EXPECT_EQ(ballsInCell(g).size(), 2u);
    const auto v = fluidVolume(g, 0.02);
    EXPECT_TRUE(v.exact);
    EXPECT_NEAR(v.value, 1 - 4 * std::numbers::pi / 3 * (0.027 + 0.064), 1e-13);
}

// Balls that overlap are left to quadrature: two unit-free balls of radius 0.3 whose centres lie 0.3 apart share the lens
// pi (4 R + s)(2 R - s)^2/12. Tangent planes
// corrected for curvature; the tolerance is 2e-5 of the whole, found sufficient at these cells, not an order of convergence.
TEST(FluidVolume, ofOverlappingBallsByQuadrature)
{
    Geometry g = emptyBox(3, {1.6, 1, 1}, {});
    const double R = 0.3, s = 0.3;
    add(g, Sphere({0.5, 0.5, 0.5}, R, FluidSide::outside));
    add(g, Sphere({0.5 + s, 0.5, 0.5}, R, FluidSide::outside));
    repeatPeriodically(g, 0.3);
    const double pi = std::numbers::pi, solid = 2 * 4 * pi / 3 * R * R * R - pi * (4 * R + s) * sqr(2 * R - s) / 12;
    const auto v = fluidVolume(g, 0.02);
    EXPECT_FALSE(v.exact);
    EXPECT_NEAR(v.value, 1.6 - solid, 3e-5);
    EXPECT_LT(v.error, 1e-4);
}

// Fluid inside a pipe and inside a ball: curvature of the other sign.
TEST(FluidVolume, insideCurvedWalls)
{
    Geometry g = emptyBox(3, {1, 1, 1}, {});
    add(g, Sphere({0.5, 0.5, 0.5}, 0.5, FluidSide::inside));
    repeatPeriodically(g, 0.3);
    EXPECT_NEAR(fluidVolume(g, 0.025).value, std::numbers::pi / 6, 2e-5);

    Geometry pipe = emptyBox(2, {1, 1, 0}, {});
    add(pipe, Cylinder({0.5, 0.5, 0}, {0, 0, 1}, 0.4, FluidSide::inside));
    repeatPeriodically(pipe, 0.3);
    EXPECT_NEAR(fluidVolume(pipe, 0.025).value, std::numbers::pi * 0.16, 2e-5);
}

// Planes across the domain cut it back exactly; a plane beside the domain, or facing away from it, does not.
TEST(FluidBox, endsAtPlanesThatCrossTheDomain)
{
    Geometry g = emptyBox(2, {1, 1, 0}, {true, false, false});
    add(g, Plane({0, 0.125, 0}, {0, 1, 0}));
    add(g, Plane({0, 0.875, 0}, {0, -1, 0}));
    add(g, Plane({0, -0.5, 0}, {0, 1, 0}));
    repeatPeriodically(g, 0.3);
    const Box b = fluidBox(g);
    EXPECT_EQ(b.low.y, 0.125);
    EXPECT_EQ(b.high.y, 0.875);
    EXPECT_EQ(b.high.x, 1);
    const auto v = fluidVolume(g, 0.02);
    EXPECT_TRUE(v.exact);
    EXPECT_NEAR(v.value, 0.75, 1e-15);
}
