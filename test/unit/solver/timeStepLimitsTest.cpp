/// Each limit by its formula with numbers worked by hand, and which one binds.
#include "solver/TimeStepLimits.hpp"
#include "models/tension/Tensions.hpp"
#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test
{
namespace
{

/// h = 0.5 m; sound 2 m/s; nothing else.
Settings quiet()
{
    Settings s;
    auto& c = s.coefficients;
    c.support = 1;
    c.phases = {"water"};
    c.restDensity = {1000};
    c.viscosity = {0};
    c.soundSpeed = {2};
    return s;
}
Settings twoPhases()
{
    auto s = quiet();
    auto& c = s.coefficients;
    c.phases = {"water", "air"};
    c.restDensity = {1000, 1};
    c.viscosity = {0, 0};
    c.soundSpeed = {2, 20};
    return s;
}
void expectLimit(const Settings& s, double deltaT, const std::string& by, double speed = 0, double acceleration = 0)
{
    const auto limit = leastOf(stepLimits(s, {speed, acceleration, 0, {}, {}}));
    EXPECT_NEAR(limit.deltaT / deltaT, 1, 1e-14);
    EXPECT_EQ(limit.by, by);
}

TEST(StepLimit, BySound) { expectLimit(quiet(), 0.4 * 0.5 / (2 + 3), "sound", 3); }
TEST(StepLimit, ByTheFasterPhase) { expectLimit(twoPhases(), 0.4 * 0.5 / 20, "sound"); }
TEST(StepLimit, ByStiffness)
{
    auto s = twoPhases();
    s.facts.give(PressureForce{PressureForce::Form::huAdams}, "test"); // c_eff = sqrt(max(1000 x 4, 1 x 400)/1) = sqrt(4000)
    expectLimit(s, 1.2 * 0.5 / std::sqrt(4000.0), "stiffness");
}
TEST(StepLimit, ByFlowAloneWherePressureIsSolvedFor)
{
    auto s = twoPhases();
    s.facts.give(PressureForce{PressureForce::Form::huAdams}, "test");
    s.integration.solves = s.integration.solvesPressure = true;
    s.coefficients.viscosity = {30, 10};
    expectLimit(s, 0.2 * 0.5 / 3, "flow", 3);
    EXPECT_EQ(leastOf(stepLimits(s, {})).by, "none");
}
TEST(StepLimit, ByViscosity)
{
    auto s = quiet();
    s.coefficients.viscosity = {5000};
    expectLimit(s, 0.125 * 0.25 / 5, "viscosity");
    s.chosen["viscosity"] = "none"; // leaves it out, and with it its limit
    expectLimit(s, 0.4 * 0.5 / 2, "sound");
}
TEST(StepLimit, ByTheViscosityOfAPairOverTheLighterDensity)
{
    auto s = twoPhases();
    s.coefficients.viscosity = {30, 10}; // pair: 2 x 30 x 10/40 = 15, over 1; air alone: 10 over 1; water alone: 0.03
    expectLimit(s, 0.125 * 0.25 / 15, "viscosity");
}
TEST(StepLimit, IsNotByImplicitSolve)
{
    auto s = twoPhases();
    s.integration.solves = true;
    s.coefficients.viscosity = {30, 10};
    s.integration.theta = 0.5;
    expectLimit(s, 0.4 * 0.5 / 20, "sound");
}
TEST(StepLimit, BySoundThatImplicitSolveDamps)
{
    auto s = quiet();
    s.integration.solves = true;
    s.coefficients.viscosity = {5000}; // nu 5 m^2/s, c 2 m/s
    expectLimit(s, 0.25 * 5 / 4, "damped sound", 0.1);
    expectLimit(s, 0.2 * 0.5 / 1, "damped sound", 1); // by a particle's way
    s.integration.theta = 0.5;
    expectLimit(s, 0.4 * 0.5 / 2, "sound");
    s.integration.theta = 1;
    s.coefficients.viscosity = {100}; // nu/c^2 short
    expectLimit(s, 0.4 * 0.5 / 2, "sound");
}
TEST(StepLimit, BySurfaceTension)
{
    auto s = twoPhases();
    s.coefficients.set(Tensions{{0, 1e6, 1e6, 0}, {}});
    expectLimit(s, 0.5 * std::sqrt(1001 * 0.125 / (4 * std::numbers::pi * 1e6)), "capillary");
}
TEST(StepLimit, ByForce) { expectLimit(quiet(), 0.25 * std::sqrt(0.5 / 1e4), "force", 0, 1e4); }
// What acts in each of five parts allows five times its step; what acts once does not.
TEST(StepLimit, OfAStepInParts)
{
    auto s = twoPhases();
    s.integration.maxSubSteps = 5;
    expectLimit(s, 5 * 0.4 * 0.5 / 20, "sound");
    expectLimit(s, 5 * 0.25 * std::sqrt(0.5 / 1e6), "force", 0, 1e6);
    s.coefficients.viscosity = {30, 10};
    expectLimit(s, 5 * 0.125 * 0.25 / 15, "viscosity");
    s.coefficients.set(Tensions{{0, 1e6, 1e6, 0}, {}});
    expectLimit(s, 0.5 * std::sqrt(1001 * 0.125 / (4 * std::numbers::pi * 1e6)), "capillary");
    const auto limits = stepLimits(s, {0, 1, 1e8, {}, {}});
    EXPECT_EQ(limits.size(), 5u);
    const auto slow = std::find_if(limits.begin(), limits.end(), [](const StepLimit& limit) { return limit.by == "slow force"; });
    ASSERT_NE(slow, limits.end());
    EXPECT_DOUBLE_EQ(slow->deltaT, 0.25 * std::sqrt(0.5 / 1e8));
    const double part = 0.125 * 0.25 / 15;
    for (const auto& [deltaT, parts] :
         {std::pair{0.1 * part, 1}, {part, 1}, {1.01 * part, 3}, {3 * part, 3}, {3.5 * part, 5}, {9 * part, 5}})
        EXPECT_EQ(partsOf(deltaT, s, limits), parts) << deltaT / part;
}
// Viscosities are those of the moment; four steps of the powder (the limit of Migration) go to one of the flow, and creeping flow has no other limit.
TEST(StepLimit, ByMigrationAndTheViscosityOfASuspension)
{
    auto s = quiet();
    s.coefficients.viscosity = {1e-9};
    const auto limitOf = [&](double leastViscosity, double largestViscosity, double ofMigration, double speed = 0, double acceleration = 0)
    {
        return leastOf(stepLimits(s, {speed, acceleration, 0, leastViscosity, largestViscosity}, {{4 * ofMigration, "migration"}}));
    };
    EXPECT_EQ(limitOf(10, 5000, 1).by, "viscosity");
    EXPECT_NEAR(limitOf(10, 5000, 1).deltaT, 0.125 * 0.25 / 5, 1e-15);
    EXPECT_EQ(limitOf(10, 5000, 1e-3).by, "migration");
    EXPECT_NEAR(limitOf(10, 5000, 1e-3).deltaT, 4e-3, 1e-18);
    s.integration.solves = true;
    EXPECT_NEAR(limitOf(5000, 1e9, 1).deltaT, 0.25 * 5 / 4, 1e-15);
    s.integration.moves = false;
    EXPECT_EQ(limitOf(10, 5000, 100, 1e9, 1e9).deltaT, 400);
}
TEST(StepLimit, FollowsTheFactors)
{
    auto s = quiet();
    s.integration.factors.sound = 0.1;
    expectLimit(s, 0.1 * 0.5 / 2, "sound");
}

}
}
