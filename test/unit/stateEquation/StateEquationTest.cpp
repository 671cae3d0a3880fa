/// Pressure, slope, energy and compression of one equation of state belong together.
#include "stateEquation/StateEquation.hpp"
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

constexpr double rho_0 = 800, c = 12;

TEST(StateEquation, HasTheSoundSpeedAtRest)
{
    for (const double n : {1.0, 1.4, 7.0})
    {
        const auto equation = StateEquation::tait(rho_0, c, n);
        EXPECT_EQ(equation.pressure(rho_0), 0) << n;
        EXPECT_NEAR(equation.slope(rho_0), c * c, 1e-12 * c * c) << n;
        EXPECT_EQ(equation.energy(rho_0), 0) << n;
    }
    // By hand: 800 * 144/7 (1.01^7 - 1), and the linear equation c^2 (rho - rho_0)
    EXPECT_NEAR(StateEquation::tait(rho_0, c, 7).pressure(808), 1187.1418, 1e-4);
    EXPECT_NEAR(StateEquation::tait(rho_0, c, 1).pressure(808), 144 * 8, 1e-10);
}

// dp/drho and de/drho = p/rho^2 by central differences, of which the error is of order 1e-8.
TEST(StateEquation, SlopeAndEnergyAreThoseOfThePressure)
{
    for (const double n : {1.0, 1.4, 7.0})
        for (const double rho : {700.0, 800.0, 1000.0})
        {
            const auto equation = StateEquation::tait(rho_0, c, n);
            const double d = 1e-4 * rho;
            const auto difference = [&](const auto& f) { return (f(rho + d) - f(rho - d)) / (2 * d); };
            EXPECT_NEAR(difference([&](double q) { return equation.pressure(q); }), equation.slope(rho), 1e-6 * equation.slope(rho)) << n;
            EXPECT_NEAR(difference([&](double q) { return equation.energy(q); }), equation.pressure(rho) / (rho * rho), 1e-6) << n;
        }
}

TEST(StateEquation, CompressionIsThePressureTheOtherWayRound)
{
    for (const double n : {1.0, 1.4, 7.0})
    {
        const auto equation = StateEquation::tait(rho_0, c, n);
        for (const double rho : {500.0, 800.0, 1100.0}) EXPECT_NEAR(equation.compression(equation.pressure(rho)), rho / rho_0, 1e-12) << n;
        EXPECT_EQ(equation.compression(equation.leastPressure()), 0) << n;
    }
}

}
}
