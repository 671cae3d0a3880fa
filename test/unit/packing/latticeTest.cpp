#include "packing/Lattice.hpp"
#include "Largest.hpp"
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

using namespace sph;

namespace
{
double closestPair(const Points& p)
{
    double closest = 1e300;
    for (std::size_t i = 0; i < p.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) closest = std::min(closest, mag(p[i] - p[j]));
    return closest;
}
}

// A channel of 0.1 m at a spacing of 0.01 m holds ten layers half a spacing off its walls; positions exact to round-off.
TEST(Lattice, fillsAChannelWithWholeLayersAtHalfSpacings)
{
    const auto lattice = Lattice({"cubic", 0.01, 0, 1}, 2, {{0, 0, 0}, {0.05, 0.1, 0}}, {true, false, false});
    EXPECT_EQ(lattice.layers, (std::array<long, 3>{5, 10, 1}));
    const auto points = lattice.points();
    ASSERT_EQ(points.size(), 50u);
    const auto [low, high] = std::minmax_element(points.y.begin(), points.y.end());
    EXPECT_NEAR(*low, 0.005, 1e-15);
    EXPECT_NEAR(*high, 0.095, 1e-15);
    EXPECT_NEAR(lattice.fittedSpacing.y, 0.01, 1e-15);
}

// A length of 10.4 spacings is filled with the nearest whole number of layers, ten, and the spacing grows by 4 %.
TEST(Lattice, stretchesToWholeNumbersOfLayers)
{
    const auto lattice = Lattice({"cubic", 0.1, 0, 1}, 3, {{0, 0, 0}, {1.04, 1, 0.96}}, {true, true, true});
    EXPECT_EQ(lattice.layers, (std::array<long, 3>{10, 10, 10}));
    EXPECT_NEAR(lattice.fittedSpacing.x, 0.104, 1e-15);
    EXPECT_NEAR(lattice.fittedSpacing.z, 0.096, 1e-15);
}

// All lattices of one spacing have the same number of particles per volume, here in boxes of whole cells (the hexagonal one is stretched
// by under 1 %), and the distance to the nearest neighbour that the lattice has at unit density: 1, (4/3)^(1/4), 2^(1/6),
// 3^(1/2)/4^(1/3).
TEST(Lattice, haveTheDensityOfTheirSpacing)
{
    struct Expected
    {
        const char* type;
        int dimension;
        double edge, particles, nearest;
    };
    const double hexagonal = std::pow(4.0 / 3, 0.25), fcc = std::cbrt(4.0), bcc = std::cbrt(2.0);
    for (const auto& [type, dimension, edge, particles, nearest] :
         {Expected{"cubic", 3, 8, 512, 1}, Expected{"hexagonal", 2, 28 * hexagonal, 2 * 28 * 16, hexagonal},
          Expected{"fcc", 3, 5 * fcc, 4 * 125, fcc / std::sqrt(2.0)}, Expected{"bcc", 3, 5 * bcc, 2 * 125, bcc * std::sqrt(3.0) / 2}})
    {
        const auto lattice = Lattice({type, 1, 0, 1}, dimension, {{0, 0, 0}, {edge, edge, edge}}, {true, true, true});
        EXPECT_EQ(double(lattice.points().size()), particles) << type;
        EXPECT_NEAR(double(lattice.points().size()) / std::pow(edge, dimension), 1, dimension == 2 ? 0.011 : 1e-12) << type;
        const auto h = lattice.fittedSpacing;
        EXPECT_NEAR(h.x * h.y * (dimension == 3 ? h.z : 1) * double(lattice.points().size()), std::pow(edge, dimension), 1e-9) << type;
        EXPECT_NEAR(closestPair(lattice.points()), nearest, dimension == 2 ? 0.01 : 1e-12) << type;
    }
}

// Periodic directions of lattices with two layers a cell get an even number of layers, so that the pattern continues across them.
TEST(Lattice, hexagonalRowsAreEvenWherePeriodic)
{
    for (const double height : {9.0, 10.0, 11.0})
    {
        const auto lattice = Lattice({"hexagonal", 1, 0, 1}, 2, {{0, 0, 0}, {10, height, 0}}, {true, true, false});
        EXPECT_EQ(lattice.layers[0] % 2, 0);
        EXPECT_EQ(lattice.layers[1] % 2, 0);
        EXPECT_EQ(long(lattice.points().size()), lattice.layers[0] * lattice.layers[1] / 2);
    }
}

// Jitter moves no particle farther than asked, moves nearly all of them, and repeats with its seed.
TEST(Lattice, jitterIsBoundedAndRepeatable)
{
    const Box box{{0, 0, 0}, {5, 5, 5}};
    const auto pointsOf = [&](double jitter, std::uint64_t seed) { return Lattice({"cubic", 1, jitter, seed}, 3, box, {}).points(); };
    const auto still = pointsOf(0, 1), one = pointsOf(0.1, 7), same = pointsOf(0.1, 7), other = pointsOf(0.1, 8);
    EXPECT_EQ(one.x, same.x);
    EXPECT_NE(one.x, other.x);
    test::Largest largest;
    double sum = 0;
    for (std::size_t i = 0; i < still.size(); ++i)
    {
        largest(one.y[i] - still.y[i]);
        sum += one.y[i] - still.y[i];
    }
    EXPECT_LE(largest.value(), 0.1);
    EXPECT_GT(largest.value(), 0.09);
    // mean of 125 uniform numbers of standard deviation 0.058: four of its standard errors
    EXPECT_NEAR(sum / 125, 0, 0.021);
}

// Every part of every lattice is that of the whole, jitter included, and counted without being made: overlapping ranges give each particle once, in the
// order of the whole.
TEST(Lattice, isKnownInAnyPartWithoutTheRest)
{
    for (const auto& [type, dimension] : {std::pair("cubic", 2), {"hexagonal", 2}, {"cubic", 3}, {"fcc", 3}, {"bcc", 3}})
    {
        const Lattice lattice({type, 1, 0.2, 5}, dimension, {{-3, 1, 2}, {4, 10, 13}}, {});
        const auto whole = lattice.points();
        EXPECT_EQ(lattice.count(lattice.all()), whole.size()) << type;
        const long nz = lattice.layers[2];
        const CellRange first{{1, 0, 0}, {5, 4, std::min(3L, nz)}}, second{{3, 2, 0}, {6, 7, nz}};
        const auto parts = lattice.points(std::array{first, second});
        std::size_t k = 0;
        for (std::size_t i = 0; i < whole.size(); ++i)
            if (k < parts.size() && whole[i] == parts[k]) ++k;
        EXPECT_EQ(k, parts.size()) << type;
        const auto onlySecond = lattice.points(std::array{second}, std::array{first});
        EXPECT_EQ(lattice.count(first) + onlySecond.size(), parts.size()) << type;
    }
}
