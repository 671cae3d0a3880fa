#include "sampling/ModeFit.hpp"
#include "verification/Bessel.hpp"
#include "verification/ColumnMode.hpp"
#include "verification/DropMode.hpp"
#include "verification/PlaneMode.hpp"
#include <gtest/gtest.h>
#include <numbers>
#include <vector>

using namespace sph;

namespace
{
using std::numbers::pi;
}

TEST(Bessel, agreesWithTheStandardLibraryAndWithTheRecurrence)
{
    for (const double x : {0.05, 0.7, 3.0, 40.0})
        for (const int n : {0, 1, 2})
        {
            EXPECT_NEAR(scaledBesselI(n, x).real() / (std::cyl_bessel_i(n, x) * std::exp(-x)), 1, 1e-11) << n << ' ' << x;
            EXPECT_NEAR(scaledBesselK(n, x).real() / (std::cyl_bessel_k(n, x) * std::exp(x)), 1, 1e-11) << n << ' ' << x;
        }
    // I_1 K_2 + I_2 K_1 = 1/z (Abramowitz & Stegun 9.6.15), along the direction of an oscillation.
    for (const double r : {0.5, 8.0, 60.0})
    {
        const auto z = std::polar(r, 0.26 * pi);
        const auto product = scaledBesselI(1, z) * scaledBesselK(2, z) + scaledBesselI(2, z) * scaledBesselK(1, z);
        EXPECT_NEAR(std::abs(z * product - 1.0), 0, 1e-11) << r;
    }
}

TEST(DropMode, agreesWithTheRootsOfADropInAVacuum)
{
    // gamma = rho = 1, R = 0.2, nu = 0.005, and water of 1 mm: roots of the 2x2 determinant of a free surface, found independently. The second fluid
    // is 1e-9 as dense and 1e-7 as viscous.
    const auto drop = dropMode(2, 0.2, 1, {1, 0.005}, {1e-9, 5e-10});
    EXPECT_NEAR(2 * pi / drop.imag(), 0.229652834, 1e-7);
    EXPECT_NEAR(-drop.real(), 0.475449738, 1e-6);
    const auto water = dropMode(2, 1e-3, 0.0728, {1000, 1e-3}, {1e-6, 1e-10});
    EXPECT_NEAR(2 * pi / water.imag(), 9.5085906e-3, 1e-9);
    EXPECT_NEAR(-water.real(), 3.8889610, 1e-5);
}

TEST(DropMode, ofTwoFluidsHasLambsFrequencyWhereViscosityVanishes)
{
    // Boundary layers damp with the root of the viscosity: 1e-10 leaves 1e-4 of the frequency.
    const auto s = dropMode(3, 0.25, 2, {1, 1e-10}, {0.4, 1e-10});
    EXPECT_NEAR(s.imag() / std::sqrt(3 * 8 * 2 / (1.4 * 0.25 * 0.25 * 0.25)), 1, 1e-4);
    EXPECT_LT(s.real(), 0);
}

TEST(BallMode, hasRayleighsFrequencyAndLambsDecay)
{
    // 8 gamma/(rho R^3) and 5 nu/R^2 of mode 2 in a vacuum: both to first order in the Ohnesorge number, whose next order is its root of the third power.
    const double R = 0.25, nu = 1e-5;
    const auto s = ballMode(2, R, 1, {1, nu}, {1e-9, 1e-14});
    EXPECT_NEAR(s.imag() / std::sqrt(8 / (R * R * R)), 1, 1e-4);
    EXPECT_NEAR(-s.real() / (5 * nu / (R * R)), 1, 2e-2);
    // Of two fluids: 2 3 1 4 gamma/((3 rho_1 + 2 rho_2) R^3).
    EXPECT_NEAR(ballMode(2, R, 1, {1, 1e-10}, {0.4, 1e-10}).imag() / std::sqrt(24 / (3.8 * R * R * R)), 1, 1e-4);
}

TEST(BallMode, isTheRootOfChandrasekharsEquationOfAGlobe)
{
    // alpha^4 = 2 q^2 (l - 1) (l + (l + 1) (q - 2 l Q)/(q - 2 Q)) - q^4, Q = J_(l+3/2)(q)/J_(l+1/2)(q), q^2 = -s R^2/nu (Chandrasekhar 1961, chapter X): roots found
    // independently, by another continued fraction. gamma = rho = 1, R = 0.25, nu = 0.02; mode 3 of R = 0.2, nu = 0.03; water of 1 mm.
    const auto near = [](Complex s, double decay, double omega)
    {
        EXPECT_NEAR(-s.real() / decay, 1, 1e-6);
        EXPECT_NEAR(s.imag() / omega, 1, 1e-7);
    };
    near(ballMode(2, 0.25, 1, {1, 0.02}, {1e-9, 2e-11}), 1.424102875862, 22.454737075862);
    near(ballMode(3, 0.2, 1, {1, 0.03}, {1e-9, 3e-11}), 8.404664508312, 59.362301433124);
    near(ballMode(2, 1e-3, 0.0728, {1000, 1e-3}, {1e-6, 1e-12}), 4.844969106876, 762.990781000739);
}

TEST(PlaneMode, isTheTabulatedRayleighTaylorRate)
{
    // Densities 1 below 3, k = 2 pi, g = 1, without and with surface tension; then the cut-off k_c^2 = (rho_2 - rho_1) g/gamma.
    const ModeFluid light{1, 1e-9}, heavy{3, 3e-9};
    EXPECT_NEAR(planeMode(2 * pi, 100, 1, 0, light, heavy).real(), 1.7724539, 1e-3);
    EXPECT_NEAR(planeMode(2 * pi, 100, 1, 0.02, light, heavy).real(), 1.378891, 1e-3);
    EXPECT_NEAR(planeMode(2 * pi, 0.5, 1, 0, light, heavy).real(), 1.7724539 * std::sqrt(std::tanh(pi)), 1e-3);
    EXPECT_LT(planeMode(10.5, 100, 1, 0.02, light, heavy).real(), 1e-2);
}

TEST(PlaneMode, isChandrasekharsRateOfViscousFluids)
{
    // Roots of his equation (113) of chapter X, by Brent's method: nu = 1/420 in both, without and with surface tension, then 1e-3 above.
    const ModeFluid light{1, 1 / 420.0}, heavy{3, 3 / 420.0};
    EXPECT_NEAR(planeMode(2 * pi, 100, 1, 0, light, heavy).real(), 1.564923223, 1e-9);
    EXPECT_NEAR(planeMode(2 * pi, 100, 1, 0.02, light, heavy).real(), 1.191116667, 1e-9);
    EXPECT_NEAR(planeMode(2 * pi, 100, 1, 0, light, {3, 3e-3}).real(), 1.617805300, 1e-9);
}

TEST(ColumnMode, isRayleighsRate)
{
    // omega/sqrt(gamma/(rho R^3)) for k R = 0.3, 0.5 and the fastest, 0.697019.
    const double R = 0.2, unit = std::sqrt(1 / (R * R * R));
    const auto rate = [&](double kR) { return columnMode(kR / R, R, 1, {1, 1e-8}, {1e-8, 1e-12}).real() / unit; };
    EXPECT_NEAR(rate(0.3), 0.201236, 1e-5);
    EXPECT_NEAR(rate(0.5), 0.301558, 1e-5);
    EXPECT_NEAR(rate(0.697019), 0.343339, 1e-5);
}

TEST(ColumnMode, tendsToTheSlenderViscousThread)
{
    // Ohnesorge number 1, k R = 0.3: 0.108259 by the one-dimensional equations (Eggers), whose error is of the order of (k R)^2.
    const double rate = columnMode(0.3, 1, 1, {1, 1}, {1e-8, 1e-8}).real();
    EXPECT_NEAR(rate, 0.10825912, 0.02 * 0.108);
}

TEST(ModeFit, recoversAnOscillationWithAnOffset)
{
    std::vector<double> t, a;
    for (int k = 0; k < 200; ++k)
    {
        t.push_back(3 + 0.01 * k);
        a.push_back(0.1 * std::exp(-1.3 * t.back()) * std::cos(19 * t.back() + 0.4) + 0.003);
    }
    const auto s = fitOscillation(t, a, {-1, 20.5});
    ASSERT_TRUE(s);
    EXPECT_NEAR(s->imag(), 19, 1e-8);
    EXPECT_NEAR(s->real(), -1.3, 1e-8);
    EXPECT_FALSE(fitOscillation(std::span(t).first(10), std::span(a).first(10), {-1, 20.5}));
}

TEST(ModeFit, recoversTheGrowthOfAVelocity)
{
    // sinh: both exponentials with the same weight.
    std::vector<double> t, a;
    for (int k = 0; k < 100; ++k)
    {
        t.push_back(0.02 * k);
        a.push_back(0.01 * std::sinh(1.7 * t.back()));
    }
    const auto s = fitGrowth(t, a, 2);
    ASSERT_TRUE(s);
    EXPECT_NEAR(*s, 1.7, 1e-5);
    EXPECT_FALSE(fitGrowth(std::span(t).first(20), std::span(a).first(20), 2));
}
