/// Observed orders, fitted slopes, Pareto fronts and expected costs, against numbers made by hand.
#include "sweeps/convergence.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

ResultRow made(const std::string& variant, double n, double error, double cost, const std::string& status = "ok")
{
    return {.variant = variant,
            .resolution = n,
            .spacing = 1 / n,
            .cpuSeconds = cost,
            .wallSeconds = cost,
            .field = "U",
            .norm = "L2",
            .error = error,
            .status = status};
}

// e = h^2 has order 2 from each row to the next, whatever the order of the rows and the ratio of their spacings.
TEST(ObservedOrder, OfAQuadraticError)
{
    std::vector<ResultRow> rows{made("a", 24, 1.0 / 576, 1), made("a", 8, 1.0 / 64, 1), made("a", 16, 1.0 / 256, 1)};
    setObservedOrders(rows);
    EXPECT_NEAR(rows[0].order, 2, 1e-12);
    EXPECT_TRUE(std::isnan(rows[1].order)); // nothing coarser
    EXPECT_NEAR(rows[2].order, 2, 1e-12);
}

// Variants do not mix; a run that failed, an error of 0 and a second run at the same spacing have no part in any order.
TEST(ObservedOrder, LooksAtGoodRowsOfItsVariantAlone)
{
    std::vector<ResultRow> rows{made("a", 8, 0.4, 1),  made("a", 16, ResultRow::unknown, 1, "diverged"),
                                made("a", 32, 0.1, 1), made("b", 16, 0.7, 1),
                                made("b", 16, 0.6, 1), made("b", 32, 0, 1)};
    setObservedOrders(rows);
    EXPECT_NEAR(rows[2].order, 1, 1e-12); // from 8 to 32
    for (const int k : {0, 1, 3, 4, 5}) EXPECT_TRUE(std::isnan(rows[k].order)) << k;
}

TEST(FittedSlope, OfAPowerLaw)
{
    const std::vector<double> x{1, 2, 4, 7}, same{3, 3};
    std::vector<double> y;
    for (const double a : x) y.push_back(0.3 * std::pow(a, -1.7));
    const auto law = fitPowerLaw(x, y);
    ASSERT_TRUE(law);
    EXPECT_NEAR(law->factor, 0.3, 1e-12);
    EXPECT_NEAR(law->exponent, -1.7, 1e-12);
    EXPECT_FALSE(fitPowerLaw(std::span(x).first(1), std::span(y).first(1)));
    EXPECT_FALSE(fitPowerLaw(same, std::span(y).first(2)));
}

// (1, 0.5) and (4, 0.1) are on the front, and (1, 0.5) twice; (2, 0.5) costs more for the same error, (4, 0.2) has more error at the
// same cost; a cheap run that failed counts for nothing.
TEST(Pareto, KeepsWhatNothingBeats)
{
    const std::vector<ResultRow> rows{made("a", 8, 0.5, 1),  made("b", 8, 0.5, 2), made("a", 16, 0.2, 4),
                                      made("b", 16, 0.1, 4), made("c", 8, 0.5, 1), made("d", 8, 0.01, 0.1, "failed")};
    EXPECT_EQ(paretoFront(rows), (std::vector<bool>{true, false, false, true, true, false}));
    EXPECT_TRUE(paretoFront({}).empty());
}

TEST(ExpectedCost, FollowsThePowerLawOfTheVariant)
{
    const std::vector<ResultRow> rows{made("a", 8, 1, 1), made("a", 16, 1, 16), made("b", 8, 1, 5), made("c", 16, 1, 100, "failed")};
    EXPECT_NEAR(expectedWallSeconds(rows, "a", 32).value(), 256, 1e-9);
    EXPECT_NEAR(expectedWallSeconds(rows, "b", 16).value(), 80, 1e-9);                          // the power 4 of a
    EXPECT_NEAR(expectedWallSeconds(rows, "c", 16).value(), 16, 1e-9);                          // another variant's own
    EXPECT_NEAR(expectedWallSeconds(std::span(rows).subspan(2, 1), "b", 16).value(), 40, 1e-9); // the usual power 3
    EXPECT_FALSE(expectedWallSeconds({}, "a", 8));
    EXPECT_FALSE(expectedWallSeconds(std::span(rows).last(1), "c", 16));
}

}
}
