/// Times at which ranks cut space anew: the cost of waiting against that of a cut.
#include "parallel/WhenToCut.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace sph::test
{
namespace
{

/// Two ranks that are asked every hundredth of a second, of whom one is busy for `ratio(t, time of the last cut)` times as long as the mean; a cut takes `cost` [s] and makes them even.
struct TwoRanks
{
    long cuts = 0;
    double waited = 0, firstCut = 0;
    template<class Ratio> TwoRanks(double end, double cost, double maxImbalance, const Ratio& ratio, double irregular = 0)
    {
        const double interval = 0.01;
        WhenToCut first, second;
        double lastCut = 0;
        unsigned random = 1;
        for (double t = 0; t < end; t += interval)
        {
            random = random * 1664525u + 1013904223u;
            const double noise = irregular * (2.0 * (random >> 8) / (1 << 24) - 1), r = ratio(t, lastCut) + noise;
            const WhenToCut::Share shares[]{first.share(r * interval, cost), second.share((2 - r) * interval, cost)};
            waited += std::fabs(r - 1) * interval;
            const bool cut = first(shares, 0, maxImbalance);
            EXPECT_EQ(second(shares, 1, maxImbalance), cut);
            EXPECT_EQ(first.imbalance(), second.imbalance());
            if (!cut) continue;
            if (cuts++ == 0) firstCut = t;
            lastCut = t;
            first.startAnew();
            second.startAnew();
        }
    }
};

// A load that stays as even as 1 % is let be.
TEST(WhenToCut, LeavesWhatIsEvenEnough)
{
    EXPECT_EQ(TwoRanks(20, 1e-3, 1.02, [](double, double) { return 1.01; }).cuts, 0);
}

// Nor is space cut because single intervals are uneven by up to 10 %, or 6 % in the rms: over twice the window, 60 of them, that is 0.75 % by chance, and 2 % are rare.
TEST(WhenToCut, LooksThroughNoise)
{
    const TwoRanks run(
        20, 1e-3, 1.02, [](double, double) { return 1.0; }, 0.1);
    EXPECT_LE(run.cuts, 5);
}

// A load that is uneven from the start, as where particles do not cost the same, is cut as soon as it is known: after 0.1 s.
TEST(WhenToCut, SeesSoonWhatIsUneven)
{
    const TwoRanks run(20, 1e-3, 1.02, [](double, double lastCut) { return lastCut > 0 ? 1.0 : 1.3; });
    EXPECT_EQ(run.cuts, 1);
    EXPECT_NEAR(run.firstCut, 0.1, 0.02);
}

// A load that moves by 5 % a second: space is cut about each 0.4 s, when 2 % are reached, and waiting costs 1 % and less. The window lags behind by its length at most.
TEST(WhenToCut, FollowsALoadThatMoves)
{
    const auto moving = [](double t, double lastCut) { return 1 + 0.05 * (t - lastCut); };
    const TwoRanks run(20, 1e-3, 1.02, moving);
    EXPECT_GT(run.cuts, 20 / (0.4 + WhenToCut::window) - 1);
    EXPECT_LT(run.cuts, 20 / 0.4 + 1);
    EXPECT_LT(run.waited, 20 * 0.05 * (0.4 + WhenToCut::window) / 2);
    // Where a cut takes 0.1 s waiting has cost as much after 2 s, whatever the limit; but only each 5 s is it 2 % of the time.
    const TwoRanks dear(200, 0.1, 1.0, moving);
    EXPECT_NEAR(double(dear.cuts), 200 / 5.0, 4);
}

// What no cut can mend, one rank's particles that are too few to share, does not lead to one after the other: they take 2 % of the time at most.
TEST(WhenToCut, DoesNotTryForever)
{
    const double cost = 5e-3;
    const TwoRanks run(50, cost, 1.02, [](double, double) { return 1.5; });
    EXPECT_GT(run.cuts, 0);
    EXPECT_LE(double(run.cuts) * cost, WhenToCut::mostOfTime * 50);
}

}
}
