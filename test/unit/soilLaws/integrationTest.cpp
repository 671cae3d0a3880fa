/// The integral of Wu & Bauer's law against an independent integrator, at tight tolerance to the six digits asked for (the tables have 10), and with steps
/// of 1e-2 to 1e-5; never tension; rotation.
#include "Largest.hpp"
#include "soilTesting.hpp"

using namespace sph;
using namespace sph::test;

namespace
{

constexpr double sixDigits = 5e-7;

/// The largest relative error of the oedometer tables, with strain steps of `step` at most.
double oedometerError(double step, const StressIntegration& how)
{
    const auto t = table("oedometer");
    Largest largest;
    SymmTensor<3> stress;
    for (std::size_t k = 0; k < t.at("K").size(); ++k)
    {
        const double strain = t.at("axial_strain")[k];
        if (strain == 0) stress = principal(-t.at("sx0_Pa")[k], -t.at("sx0_Pa")[k], -t.at("sz0_Pa")[k]);
        const auto now = inSteps(karlsruhe, stress, diagonal(0, 0, -1), strain, step, how);
        largest(relative(-now.zz, t.at("sz_Pa")[k]));
        if (t.at("sx_Pa")[k] > 0) largest(relative(-now.xx, t.at("sx_Pa")[k]));
    }
    return largest.value();
}

/// Stresses of simple shear at constant volume against its table.
double shearError(double step, const StressIntegration& how)
{
    const auto t = table("simpleShear", "const-volume,");
    Largest largest;
    for (std::size_t k = 0; k < t.at("gamma").size(); ++k)
    {
        const auto now = inSteps(karlsruhe, principal(-1e5, -1e5, -1e5), {0, 0, 1, 0, 0, 0, 0, 0, 0}, t.at("gamma")[k], step, how);
        const double tr = t.at("sx")[k] + t.at("sy")[k] + t.at("sz")[k];
        for (const auto& [mine, its] : {std::pair{now.xx, "sx"}, {now.yy, "sy"}, {now.zz, "sz"}, {now.xz, "sxz"}})
            largest((mine + t.at(its)[k]) / tr);
    }
    return largest.value();
}

TEST(SoilIntegration, oedometer)
{
    EXPECT_LT(oedometerError(0.1, tight()), sixDigits);
    StressIntegration how;
    for (const double step : {1e-2, 1e-3}) { EXPECT_LT(oedometerError(step, how), 1e-5); }
    how.pair = &bogackiShampine;
    EXPECT_LT(oedometerError(1e-2, how), 1e-4); // errors accumulate over the many substeps of an order lower
}

TEST(SoilIntegration, simpleShearAtConstantVolume)
{
    EXPECT_LT(shearError(0.1, tight()), sixDigits);
    StressIntegration how;
    how.turning = Turning::within;
    EXPECT_LT(shearError(1e-2, how), 1e-5);
    // A mean direction in each step is of second order: measured 6e-4, 6e-6.
    how.turning = Turning::halves;
    const double coarse = shearError(1e-2, how), fine = shearError(1e-3, how);
    EXPECT_LT(coarse, 1e-3);
    EXPECT_NEAR(coarse / fine, 100, 50);
}

// K after szz has grown: the tables have five digits.
TEST(SoilIntegration, earthPressureOfGrowth)
{
    const auto t = table("earthPressure");
    for (std::size_t k = 0; k < t.at("K").size(); ++k)
    {
        const double K = t.at("K_initial")[k], growth = t.at("sz_growth_factor")[k];
        double low = 0, high = 0.2;
        SymmTensor<3> now;
        for (int bisections = 0; bisections < 50; ++bisections)
        {
            const double strain = 0.5 * (low + high);
            now = inSteps(karlsruhe, principal(-K, -K, -1), diagonal(0, 0, -1), strain, 1, tight());
            (-now.zz < growth ? low : high) = strain;
        }
        EXPECT_NEAR(now.xx / now.zz, t.at("K")[k], 6e-6) << K << " " << growth;
    }
}

TEST(SoilIntegration, isotropic)
{
    for (const double volume : {1e-2, 1e-3})
    {
        const auto p = [&](double sign)
        { return -inSteps(karlsruhe, principal(-1, -1, -1), diagonal(sign / 3, sign / 3, sign / 3), volume, 1, tight()).xx; };
        EXPECT_LT(relative(p(-1), std::exp(167.5387 * volume)), 1e-6);
        EXPECT_LT(relative(p(1), std::exp(-419.9947 * volume)), 1e-6);
    }
}

SymmTensor<3> turnedAtRandom(SymmTensor<3> s, std::mt19937& generator)
{
    std::normal_distribution<double> any;
    const double x = any(generator), y = any(generator), z = any(generator);
    return rotated(s, rotationOf({0, -z, y, z, 0, -x, -y, x, 0}));
}

// 2000 random states, K from 0 to 1, of any axes, deformed in any direction, with spin: no tension, no change of sign, and the right answer. Extension by 0.1 takes the
// stress down by exp(-40) and further.
TEST(SoilIntegration, randomStatesAndDirections)
{
    std::mt19937 generator(1);
    std::uniform_real_distribution<double> share(0, 1);
    std::normal_distribution<double> any;
    for (const double size : {1e-5, 1e-4, 1e-3, 1e-2, 1e-1})
    {
        Largest error;
        for (int k = 0; k < 2000; ++k)
        {
            const auto stress = turnedAtRandom(1e5 * principal(-share(generator), -share(generator), -1), generator);
            Tensor<3> L{any(generator), any(generator), any(generator), any(generator), any(generator),
                        any(generator), any(generator), any(generator), any(generator)};
            L = size / norm(symm(L)) * L;
            StressIntegration how;
            how.floorPressure = 1e-90;
            how.turning = Turning::within;
            const auto step = integrateStress(karlsruhe, stress, L, how);
            ASSERT_EQ(step.state, StressState::regular);
            ASSERT_LT(trace(step.stress), 0);
            ASSERT_TRUE(isCompressive(step.stress));
            how.tolerance = 1e-11;
            const auto exact = integrateStress(karlsruhe, stress, L, how).stress;
            error(norm(step.stress - exact) / std::abs(trace(exact)));
        }
        EXPECT_LT(error.value(), size > 0.05 ? 5e-5 : 1e-5) << size;
    }
}

// One turn in any number of steps: the stress turns with it, to rounding.
TEST(SoilIntegration, rigidRotation)
{
    const auto stress = principal(-30, -20, -50);
    constexpr double turn = 2 * std::numbers::pi;
    for (const auto turning : {Turning::halves, Turning::within})
        for (const int steps : {1, 4, 100, 10000})
        {
            auto how = tight();
            how.turning = turning;
            const double w = turn / steps;
            auto now = stress;
            for (int k = 0; k < steps; ++k)
            {
                now = integrateStress(karlsruhe, now, {0, 0, w, 0, 0, 0, -w, 0, 0}, how).stress;
                if (4 * (k + 1) == steps) { EXPECT_LT(norm(now - principal(-50, -20, -30)), 1e-10); }
            }
            EXPECT_LT(norm(now - stress), 1e-10);
            EXPECT_LT(std::abs(norm(now) / norm(stress) - 1), 1e-11);
        }
}

// The plane-strain law of ten turns while it is compressed gives the same as the compression in axes that turn with it.
TEST(SoilIntegration, anyFrame)
{
    const auto L = Tensor<3>{-0.01, 0.004, 0.002, 0, -0.003, 0.006, 0.001, 0, -0.02};
    const auto stress = SymmTensor<3>{-4e4, 1e4, 0, -5e4, 5e3, -9e4};
    const auto Q = rotationOf({0, -0.3, 0.9, 0.3, 0, -1.2, -0.9, 1.2, 0});
    const auto here = rotated(integrateStress(karlsruhe, stress, L, tight()).stress, Q);
    const auto there = integrateStress(karlsruhe, rotated(stress, Q), Q * L * transpose(Q), tight()).stress;
    EXPECT_LT(norm(here - there) / norm(here), 1e-10);
}

TEST(SoilIntegration, stressFree)
{
    StressIntegration how;
    how.floorPressure = 10;
    const auto apart = diagonal(0.02, 0.02, 0.02), together = diagonal(-0.02, -0.02, -0.02);
    const auto down = integrateStress(karlsruhe, principal(-100, -80, -90), apart, how);
    EXPECT_EQ(down.state, StressState::stressFree);
    EXPECT_NEAR(-trace(down.stress) / 3, 10, 1e-9);
    EXPECT_TRUE(isCompressive(down.stress));
    const auto none = integrateStress(karlsruhe, {}, together, how); // from the floor up
    EXPECT_EQ(none.state, StressState::stressFree);
    EXPECT_LT(relative(-none.stress.xx, 10 * std::exp(167.5387 * 0.06)), 1e-5);

    how.stressFree = StressFree::detached;
    const auto lost = integrateStress(karlsruhe, principal(-100, -80, -90), apart, how);
    EXPECT_EQ(lost.state, StressState::stressFree);
    EXPECT_EQ(norm(lost.stress), 0);
    EXPECT_EQ(norm(integrateStress(karlsruhe, lost.stress, together, how).stress), 0);
}

// Extension without end: the underflow of the stress is caught by the floor.
TEST(SoilIntegration, extensionWithoutEnd)
{
    StressIntegration how;
    how.floorPressure = 1e-100;
    const auto step = integrateStress(karlsruhe, principal(-1e5, -1e5, -1e5), diagonal(3, 2, 1), how);
    EXPECT_EQ(step.state, StressState::stressFree);
    EXPECT_TRUE(isCompressive(step.stress));
    EXPECT_TRUE(std::isfinite(norm(step.stress)));
}

TEST(SoilIntegration, tensionAtTheStartIsSaid)
{
    for (const auto& stress : {principal(1, 1, 1), principal(-10, 0.001, -10), SymmTensor<3>{-5, 6, 0, -5, 0, -5}})
    {
        const auto step = integrateStress(karlsruhe, stress, diagonal(-0.01, 0, 0), {});
        EXPECT_EQ(step.state, StressState::inadmissible);
        EXPECT_EQ(norm(step.stress - stress), 0);
    }
}

// y' = y cos(t): errors of a fixed tolerance, and the orders that the pairs are named by.
TEST(EmbeddedPairs, orders)
{
    for (const auto* pair : {&dormandPrince, &bogackiShampine})
    {
        const auto errorAt = [&](int steps)
        {
            double y = 1;
            for (int n = 0; n < steps; ++n)
            {
                SymmTensor<3> state{y};
                integrate(
                    *pair, state, 1,
                    [&](double t, SymmTensor<3> s) { return SymmTensor<3>{s.xx * std::cos((n + t) * 2 / steps) * 2 / steps}; },
                    [](SymmTensor<3>, SymmTensor<3>) { return 0.0; }, [](SymmTensor<3>) { return true; },
                    [](SymmTensor<3>&) { return false; }, [](SymmTensor<3>) { return false; });
                y = state.xx;
            }
            return std::abs(y - std::exp(std::sin(2.0)));
        };
        EXPECT_NEAR(std::log2(errorAt(20) / errorAt(40)), pair->order, 0.2) << pair->name;
    }
}

// Where two principal stresses are equal the formula for eigenvalues errs by 1e-8; the test for tension does not.
TEST(SoilIntegration, tensionToRounding)
{
    std::mt19937 generator(2);
    for (int k = 0; k < 1000; ++k)
    {
        EXPECT_TRUE(isCompressive(turnedAtRandom(principal(0, 0, -1e5), generator)));
        EXPECT_TRUE(isCompressive(turnedAtRandom(principal(0, -1e5, -1e5), generator)));
        EXPECT_FALSE(isCompressive(turnedAtRandom(principal(1e-5, 0, -1e5), generator)));
        EXPECT_FALSE(isCompressive(turnedAtRandom(principal(1e-5, -1e5, -1e5), generator)));
    }
}

}
