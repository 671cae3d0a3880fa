/// From particles to a number: the same bits on any number of threads, and nothing that is no number gets lost.
#include "parallel/reduce.hpp"
#include "Largest.hpp"
#include <gtest/gtest.h>
#include <limits>
#include <omp.h>
#include <random>

namespace sph::test
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity(), nan = std::numeric_limits<double>::quiet_NaN();

/// Numbers of either sign and of sizes from 1e-8 to 1e8, so that any other order of additions shows.
std::vector<double> unlike(std::size_t n)
{
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> exponent(-8, 8), sign(-1, 1);
    std::vector<double> q(n);
    for (double& each : q) each = std::copysign(std::pow(10, exponent(random)), sign(random));
    return q;
}
struct Two
{
    double a = 0, b = 0;
    Two& operator+=(const Two& other)
    {
        a += other.a;
        b += other.b;
        return *this;
    }
};

// 1024 to a block, and blocks in their order: what a plain loop over either gives, to the bit. Lengths end at, before and after a block.
TEST(Reduce, GivesTheSameBitsOnAnyNumberOfThreads)
{
    for (const std::size_t n : {0ul, 1ul, 1023ul, 1024ul, 1025ul, 50000ul})
    {
        const auto q = unlike(n);
        double expected = 0, leastOfAll = infinity, mostOfAll = -infinity;
        for (std::size_t begin = 0; begin < n; begin += 1024)
        {
            double part = 0;
            for (std::size_t i = begin; i < std::min(n, begin + 1024); ++i) part += q[i];
            expected += part;
        }
        for (const double each : q)
        {
            leastOfAll = std::min(leastOfAll, each);
            mostOfAll = std::max(mostOfAll, each);
        }
        for (const int threads : {1, 2, 3})
        {
            omp_set_num_threads(threads);
            const auto value = [&](std::size_t i) { return q[i]; };
            EXPECT_EQ(sum(n, value), expected) << n << " on " << threads;
            EXPECT_EQ(least(n, value), leastOfAll);
            EXPECT_EQ(most(n, value), mostOfAll);
            const auto both = sum(n, [&](std::size_t i) { return Two{q[i], -q[i]}; });
            EXPECT_EQ(both.a, expected);
            EXPECT_EQ(both.b, -expected);
            const auto byBlocks = reduceBlocks(
                n, 0.0,
                [&](std::size_t begin, std::size_t end)
                {
                    double part = 0;
                    for (std::size_t i = begin; i < end; ++i) part += q[i];
                    return part;
                },
                Add{});
            EXPECT_EQ(byBlocks, expected);
        }
    }
    // The order shows in these numbers: the sum the other way round has other bits.
    const auto q = unlike(50000);
    EXPECT_NE(sum(50000, [&](std::size_t i) { return q[i]; }), sum(50000, [&](std::size_t i) { return q[49999 - i]; }));
}

// A NaN or an infinity anywhere, in the first block or the last, alone or before and after a larger number, is in the result.
TEST(Reduce, KeepsNaNAndInfinity)
{
    const std::size_t n = 9000;
    for (const int threads : {1, 3})
    {
        omp_set_num_threads(threads);
        for (const std::size_t at : {0ul, 17ul, 1023ul, 1024ul, 8999ul})
        {
            const auto with = [&](double special) { return [=](std::size_t i) { return i == at ? special : double(i) - 4000; }; };
            EXPECT_TRUE(std::isnan(least(n, with(nan)))) << at;
            EXPECT_TRUE(std::isnan(most(n, with(nan)))) << at;
            EXPECT_TRUE(std::isnan(sum(n, with(nan)))) << at;
            EXPECT_EQ(most(n, with(infinity)), infinity);
            EXPECT_EQ(least(n, with(-infinity)), -infinity);
            EXPECT_EQ(sum(n, with(infinity)), infinity);
            EXPECT_EQ(sum(n, with(-infinity)), -infinity);
            EXPECT_EQ(most(n, with(-infinity)), at == 8999 ? 4998 : 4999);
            EXPECT_EQ(least(n, with(infinity)), at == 0 ? -3999 : -4000);
        }
        EXPECT_TRUE(std::isnan(sum(n, [](std::size_t i) { return i == 5 ? infinity : i == 8000 ? -infinity : 1; })));
    }
}

// What tests keep the worst deviation by, too: first, last or in between, before and after larger numbers, NaN is what a bound is compared with.
TEST(Largest, KeepsNaNAndItsPlace)
{
    for (const std::size_t at : {0ul, 4ul, 9ul})
    {
        Largest worst;
        for (std::size_t i = 0; i < 10; ++i) worst(i == at ? nan : i == 5 ? -20.0 : double(i), i);
        EXPECT_TRUE(std::isnan(worst.value()));
        EXPECT_FALSE(worst.value() < 1e300);
        EXPECT_EQ(worst.at(), at);
    }
    Largest worst;
    EXPECT_EQ(worst.value(), 0);
    for (const double q : {1.0, -20.0, 3.0, -infinity, 5.0}) worst(q, std::size_t(std::abs(q) < 10 ? q : 7));
    EXPECT_EQ(worst.value(), infinity);
    EXPECT_EQ(worst.at(), 7u);
}

// Every third element to one of three groups and none of the fourth: the same bits as the sum of a group alone, in which all others are zeros.
TEST(Reduce, GivesEachGroupItsSum)
{
    const std::size_t n = 50000;
    const auto q = unlike(n);
    for (const int threads : {1, 3})
    {
        omp_set_num_threads(threads);
        const auto value = [&](std::size_t i) { return q[i]; };
        const auto sums = groupSums(
            n, 3, [](std::size_t i) { return i % 4; }, value);
        ASSERT_EQ(sums.size(), 3u);
        for (std::size_t g = 0; g < 3; ++g) EXPECT_EQ(sums[g], sum(n, [&](std::size_t i) { return i % 4 == g ? q[i] : 0; })) << g;
        EXPECT_EQ(count(n, [](std::size_t i) { return i % 4 == 3; }), n / 4);
    }
}

TEST(Reduce, OfNothingIsWhereItStarts)
{
    const auto none = [](std::size_t) { return 1.0; };
    EXPECT_EQ(sum(0, none), 0);
    EXPECT_EQ(count(0, none), 0u);
    EXPECT_EQ(groupSums(
                  0, 2, [](std::size_t) { return 0; }, none),
              (std::vector<double>{0, 0}));
    EXPECT_EQ(least(0, none), infinity);
    EXPECT_EQ(most(0, none), -infinity);
}

}
}
