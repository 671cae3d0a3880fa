/// Copies and messages of ranks, against a count by hand.
#include "decomposition/estimate.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace sph;

namespace
{
std::vector<Vector<3>> square(int n)
{
    std::vector<Vector<3>> places;
    for (int i = 0; i < n * n; ++i) places.push_back({i % n + 0.5, i / n + 0.5, 0});
    return places;
}

Geometry domain(double side, bool periodic)
{
    Geometry g;
    g.dimension = 2;
    g.high = {side, side, 1};
    g.periodic = {periodic, periodic, false};
    return g;
}

// Sixteen tiles of 8 x 8 particles, which a reach of 2.9 spacings gives three rows of copies along each side, and six at each corner: those with
// (a - 1/2)^2 + (b - 1/2)^2 < 2.9^2.
TEST(Estimate, CountsCopiesAndMessages)
{
    const auto places = square(32);
    const auto periodic = loadOf(domain(32, true), places, 16, 2.9, 1);
    EXPECT_EQ(periodic.particles, std::vector<double>(16, 64));
    EXPECT_EQ(periodic.copies, std::vector<double>(16, 4 * 3 * 8 + 4 * 6));
    EXPECT_EQ(periodic.neighbours, std::vector<double>(16, 8));
    auto closed = loadOf(domain(32, false), places, 16, 2.9, 1);
    std::ranges::sort(closed.copies);
    EXPECT_EQ(closed.copies.front(), 2 * 3 * 8 + 6) << "in a corner of the domain";
    EXPECT_EQ(closed.copies.back(), 4 * 3 * 8 + 4 * 6) << "in its middle";
    EXPECT_EQ(*std::ranges::min_element(closed.neighbours), 3);
}

// A part that is smaller than the reach sees beyond those next to it, and a particle that is seen through two faces is one copy.
TEST(Estimate, CountsEachCopyOnce)
{
    const auto places = square(4);
    const auto load = loadOf(domain(4, true), places, 16, 2.9, 1);
    EXPECT_EQ(load.particles, std::vector<double>(16, 1));
    EXPECT_EQ(load.copies, std::vector<double>(16, 15));
    EXPECT_EQ(load.neighbours, std::vector<double>(16, 15));
}

// 0.5 us of 8 messages twice, and 8 bytes of 3 numbers of 100 copies at 1e9 bytes/s, beside 64 particles of 1 us.
TEST(Estimate, SharesTimeByLatencyAndBandwidth)
{
    const Costs costs{.latency = 0.5e-6, .bandwidth = 1e9, .secondsPerParticle = 1e-6, .refreshes = 2, .values = 3};
    EXPECT_NEAR(shareOfCommunication(costs, 64, 100, 8), (8e-6 + 2.4e-6) / (8e-6 + 2.4e-6 + 64e-6), 1e-12);
}

// Four times the particles: tiles of 16 x 16, counted by the formula and as they are.
TEST(Estimate, ScalesByTheSurface)
{
    const double reach = 2.9;
    const auto load = loadOf(domain(32, true), square(32), 16, reach, 1), larger = loadOf(domain(64, true), square(64), 16, reach, 1);
    const auto scaled = scaledTo(load, 64 * 64, 2, reach, 1);
    EXPECT_EQ(scaled.particles, 256);
    EXPECT_EQ(scaled.neighbours, 8);
    EXPECT_NEAR(scaled.copies, larger.copies[0], 0.02 * larger.copies[0]);
}

}
