#include "sampling/Formulas.hpp"
#include "Particles.hpp"
#include "verification/BosanquetRise.hpp"
#include "verification/Couette.hpp"
#include "verification/Hydrostatic.hpp"
#include "verification/PlanePoiseuille.hpp"
#include "verification/Ritter.hpp"
#include "verification/RotatingSquarePatch.hpp"
#include "verification/SuspensionChannel.hpp"
#include "verification/TaylorGreen.hpp"
#include "verification/TwoLayerPoiseuille.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>

using namespace sph;

// The tabulated values were computed by an independent series in another language, to 7 or 8 digits; hence the tolerances.

TEST(PlanePoiseuille, agreesWithTheTabulatedSeries)
{
    const PlanePoiseuille flow(1e-6, 1e-4, 1e-3);
    const auto at = [&](double y, double tau) { return flow.speed(y, tau * 1e-3 * 1e-3 / 1e-6); };
    EXPECT_NEAR(at(0.5e-3, 0.1), 7.691906e-6, 1e-12);
    EXPECT_NEAR(at(2.5e-5, 0.0225), 3.9287047e-07, 1e-14);
    EXPECT_NEAR(at(5e-5, 0.045), 1.0766441e-06, 1e-13);
    EXPECT_NEAR(at(0.975e-3, 0.045), 5.6751418e-07, 1e-14);
    EXPECT_NEAR(at(0.5e-3, 100), 1.25e-5, 1e-17);
}

TEST(PlanePoiseuille, startsFromRestAndKeepsThePlatesAtRest)
{
    // The plates are not felt in the middle at nu t/L^2 = 1e-6: v = F t to round-off.
    const PlanePoiseuille flow(1e-6, 1e-4, 1e-3);
    EXPECT_EQ(flow.speed(3e-4, 0), 0);
    EXPECT_NEAR(flow.speed(5e-4, 1e-6), 1e-10, 1e-24);
    for (const double t : {1e-6, 1e-2, 0.2, 10.0})
    {
        EXPECT_NEAR(flow.speed(0, t), 0, 1e-20) << t;
        EXPECT_NEAR(flow.speed(1e-3, t), 0, 1e-20) << t;
    }
}

TEST(PlanePoiseuille, imagesAndSeriesMeetWhereOneTakesOver)
{
    // Either side of nu t/L^2 = 0.05; the difference over 2e-9 of that time is 2e-15 of F t.
    const PlanePoiseuille poiseuille(1, 1, 1);
    const Couette couette(1, 1, 1);
    for (const double y : {0.01, 0.1, 0.37, 0.5, 0.8, 0.99})
    {
        EXPECT_NEAR(poiseuille.speed(y, 0.05 * (1 - 1e-9)), poiseuille.speed(y, 0.05), 1e-10);
        EXPECT_NEAR(couette.relativeSpeed(y, 0.05 * (1 - 1e-9)), couette.relativeSpeed(y, 0.05), 1e-9);
    }
}

TEST(Couette, agreesWithTheTabulatedSeries)
{
    const Couette flow(1e-6, 1.25e-5, 1e-3);
    EXPECT_NEAR(flow.relativeSpeed(0.5e-3, 0.1), 0.262756, 1e-6);
    EXPECT_NEAR(flow.velocity({0, 0.725e-3, 0}, 0.0225).x, 2.4356331e-6, 1e-13);
    EXPECT_NEAR(flow.velocity({0, 1e-4, 0}, 0.045).x, 3.0675791e-8, 1e-15);
    EXPECT_NEAR(flow.relativeSpeed(0.3e-3, 100), 0.3, 1e-14);
    EXPECT_EQ(flow.relativeSpeed(0.3e-3, 0), 0);
    EXPECT_NEAR(flow.relativeSpeed(1e-3, 1e-3), 1, 1e-14);
}

TEST(TaylorGreen, decaysAsTabulatedAndHasNoDivergence)
{
    // U = L = 1, nu = 0.01: rate 0.789568; greatest speed 0.853923 at t = 0.2. Divergence by central differences of step 1e-4.
    const TaylorGreen flow(1, 1, 0.01, 1);
    EXPECT_NEAR(mag(flow.velocity({0.25, 0, 0}, 0.2)), 0.8539234976456128, 1e-14);
    EXPECT_NEAR(mag(flow.velocity({0.25, 0, 0}, 0.4)), 0.729185339831317, 1e-14);
    const double d = 1e-4;
    const Vector<3> x{0.13, 0.41, 0};
    const double divergence = (flow.velocity(x + Vector<3>{d, 0, 0}, 0).x - flow.velocity(x - Vector<3>{d, 0, 0}, 0).x +
                               flow.velocity(x + Vector<3>{0, d, 0}, 0).y - flow.velocity(x - Vector<3>{0, d, 0}, 0).y) /
                              (2 * d);
    EXPECT_NEAR(divergence, 0, 1e-10);
}

TEST(TaylorGreen, pressureBalancesTheConvection)
{
    // rho u.grad u = -grad p in x; central differences of step 1e-4 are exact to 1e-6 of k^3 U^2.
    const TaylorGreen flow(2, 1, 0, 3);
    const double d = 1e-4;
    const Vector<3> x{0.13, 0.41, 0}, dx{d, 0, 0}, dy{0, d, 0};
    const auto u = flow.velocity(x, 0);
    const double dudx = (flow.velocity(x + dx, 0).x - flow.velocity(x - dx, 0).x) / (2 * d),
                 dudy = (flow.velocity(x + dy, 0).x - flow.velocity(x - dy, 0).x) / (2 * d),
                 dpdx = (flow.pressure(x + dx, 0) - flow.pressure(x - dx, 0)) / (2 * d);
    EXPECT_NEAR(3 * (u.x * dudx + u.y * dudy), -dpdx, 1e-4);
    EXPECT_GT(std::abs(dpdx), 1);
}

TEST(Hydrostatic, addsUpTheLayersAbove)
{
    // 0.5 m of density 1 over 0.5 m of 1000: 4.905 Pa at the interface, 4909.905 Pa at the bottom; 0 at the top and above.
    const Hydrostatic rest({0.5, 0.5}, {1000, 1}, {0, -9.81, 0});
    EXPECT_NEAR(rest.pressure({0, 0.5, 0}, 0), 4.905, 1e-12);
    EXPECT_NEAR(rest.pressure({0, 0, 0}, 0), 4909.905, 1e-9);
    EXPECT_NEAR(rest.pressure({0, 0.25, 0}, 0), 4.905 + 2452.5, 1e-9);
    EXPECT_EQ(rest.pressure({0, 1, 0}, 0), 0);
    EXPECT_EQ(rest.pressure({0, 1.2, 0}, 0), 0);
    EXPECT_NEAR(rest.pressure({0, -0.1, 0}, 0), 4909.905 + 981, 1e-9);
}

TEST(TwoLayerPoiseuille, agreesWithTheTabulatedSolutions)
{
    const TwoLayerPoiseuille byPressure(1e-3, 1.8e-5, 5e-4, 5e-4, 1, 1), byForce(1e-3, 1.8e-5, 5e-4, 5e-4, 1, 1e-3);
    EXPECT_NEAR(byPressure.speed(5e-4), 2.455796e-4, 1e-10);
    EXPECT_NEAR(byPressure.speed(2.2e-3 / 3), 1.859371e-3, 1e-9);
    EXPECT_NEAR(byPressure.speed(1.66667e-5), 1.2213763e-5, 1e-10);
    EXPECT_NEAR(byForce.speed(5e-4), 1.229126e-4, 1e-10);
    EXPECT_NEAR(byForce.speed(3.83333e-4), 1.1659408e-4, 1e-10);
    EXPECT_NEAR(byForce.wallStress(), 4.958251e-4, 1e-10);
    EXPECT_NEAR(byPressure.speed(5e-4 - 1e-15), byPressure.speed(5e-4), 1e-12);
    EXPECT_NEAR(byPressure.speed(1e-3), 0, 1e-18);
}

TEST(BosanquetRise, agreesWithTheTabulatedCurves)
{
    // Slits of 1 mm, 30 degrees, that touch the liquid: water, and a fluid of 0.04 N/m and 4 mPa s. Integrated with another method to 6 digits, times rounded as well.
    const double cosine = std::cos(std::numbers::pi / 6);
    const BosanquetRise water{0.0728, cosine, 1000, 1000, 1e-3, 9.81, 1e-3, 0, 0, 0},
        other{0.04, cosine, 1000, 1000, 4e-3, 9.81, 1e-3, 0, 0, 0};
    EXPECT_NEAR(water.height(0.00125893), 0.000443334, 2e-9);
    EXPECT_NEAR(water.height(0.0199526), 0.00618791, 2e-8);
    EXPECT_NEAR(water.height(0.316228), 0.0135832, 1e-7);
    EXPECT_NEAR(other.height(0.0125893), 0.00277643, 2e-8);
    EXPECT_NEAR(other.height(0.199526), 0.00703548, 1e-8);
    EXPECT_NEAR(other.height(10), 0.0070623886, 1e-9);
    EXPECT_NEAR(other.heightAtRest(), 0.0070623886, 1e-10);
}

TEST(BosanquetRise, endsAtTheHeightAtRestWithAReservoirThatSinks)
{
    const BosanquetRise rise{1, 0.5, 1, 0.99, 0.3, 0.4, 1, 1.25, 2, 0.25};
    EXPECT_NEAR(rise.height(1000), 0.75 / (0.99 * 0.4), 1e-9);
    EXPECT_EQ(rise.height(0), 0);
}

TEST(BosanquetRise, withTheFrictionOfTankAndLineOfContact)
{
    // The same equations in l and v, by another integrator to 10 digits.
    const BosanquetRise rise{1, 0.5, 1, 0.99, 0.1, 0.25253, 1, 1.25, 2, 0.25, 1.0 / 32};
    EXPECT_NEAR(rise.height(4), 0.879124669, 1e-7);
    EXPECT_NEAR(rise.height(12), 1.916994395, 1e-7);
    EXPECT_NEAR(rise.height(40), 2.850653010, 1e-7);
}

TEST(Formulas, areReadFromDictionaries)
{
    auto diagnostics = std::make_shared<Diagnostics>();
    const auto d = Dictionary::parse("name planePoiseuille; nu [0 2 -1 0 0 0 0] 1e-6; acceleration 1e-4; width 1e-3;\n"
                                     "direction (0 0 2); normal (1 0 0); origin (1 0 0);\n",
                                     "system/controlDict", diagnostics);
    const auto U = readFormula("planePoiseuille", d, "U");
    EXPECT_EQ(errorsOf(*diagnostics), "");
    const auto u = U({1.0005, 7, 7}, 0.1);
    EXPECT_NEAR(u.z, 7.691906e-6, 1e-12);
    EXPECT_EQ(u.x, 0);
}

TEST(Formulas, mistakesNameFileAndLine)
{
    auto diagnostics = std::make_shared<Diagnostics>();
    const auto d = Dictionary::parse("name hydrostatic;\nheights (1 2);\ndensities (1000);\n", "system/controlDict", diagnostics);
    readFormula("hydrostatic", d, "U");
    readFormula("hydrostatic", d, "p");
    EXPECT_EQ(errorsOf(*diagnostics), "system/controlDict:1: formula \"hydrostatic\" gives p, not U\n"
                                      "system/controlDict:3: 1 densities for 2 heights: one of each per layer, from the bottom up\n"
                                      "2 errors");
}

// What another field of the formula alone needs is an error, as any entry that nobody reads; with that field it is not.
TEST(Formulas, parametersOfAnotherFieldAreErrors)
{
    struct Idle
    {
        std::string formula, entry, needs, other;
        std::string more = {};
    };
    for (const auto& [formula, entry, needs, other, more] :
         {Idle{"taylorGreen", "rho 2;", "p", "U", "speed 1; period 1;"}, Idle{"ritter", "rho 2;", "p", "U", "depth 1;"},
          Idle{"ritter", "up (0 1 0);", "p", "U", "depth 1;"},
          Idle{"suspensionChannel", "mu 2;", "U", "phi", "width 1; phi 0.5; phiMax 0.7; exponent 1; ratio 0.5;"},
          Idle{"suspensionChannel", "pressureGradient 2;", "U", "phi", "width 1; phi 0.5; phiMax 0.7; exponent 1; ratio 0.5;"}})
    {
        const auto errorsWith = [&](const std::string& field)
        {
            auto diagnostics = std::make_shared<Diagnostics>();
            readFormula(formula,
                        Dictionary::parse("name " + formula + "; " + more + "\n" + entry + "\n", "system/controlDict", diagnostics), field);
            return errorsOf(*diagnostics);
        };
        const auto keyword = entry.substr(0, entry.find(' '));
        EXPECT_EQ(errorsWith(needs), "") << formula << ' ' << keyword;
        EXPECT_EQ(errorsWith(other), "system/controlDict:2: " + keyword + " does nothing here: " + other + " of " + formula +
                                         " does not need it; leave it out");
    }
}

TEST(Ritter, isTheDamBreakOfShallowWater)
{
    // c = sqrt(9.81) for a depth of 1 m; at the dam 4/9 of the depth at 2/3 c, whatever the time, so that 8/27 c flows there.
    const Ritter flow(1, 9.81, 1000);
    const double c = std::sqrt(9.81);
    for (const double t : {0.1, 0.5, 7.0})
    {
        EXPECT_NEAR(flow.depth(0, t), 4.0 / 9, 1e-14);
        EXPECT_NEAR(flow.speed(0, t), 2 * c / 3, 1e-14);
        EXPECT_EQ(flow.depth(-1.001 * c * t, t), 1);
        EXPECT_EQ(flow.speed(-1.001 * c * t, t), 0);
        EXPECT_EQ(flow.depth(2.001 * c * t, t), 0);
    }
    // A row of an independently computed table at t = 0.5 s.
    EXPECT_NEAR(flow.depth(-1.4094413787029243, 0.5), 0.9344444444444445, 1e-13);
    EXPECT_NEAR(flow.speed(-1.4094413787029243, 0.5), 0.20880613017821106, 1e-13);
    EXPECT_NEAR(flow.pressure({0, 0.1, 0}, 3), 9810 * (4.0 / 9 - 0.1), 1e-9);
    EXPECT_EQ(flow.pressure({0, 0.5, 0}, 3), 0);
    EXPECT_EQ(flow.depth(-0.1, 0), 1);
    EXPECT_EQ(flow.depth(0.1, 0), 0);
    EXPECT_EQ(flow.speed(0.1, 0), 0);
}

TEST(Ritter, keepsTheMassAndTheMomentumBalance)
{
    // Volume beyond the dam: 8/27 c t h_0, by the sum of 10^5 slices (to 1e-9). dh/dt + d(h u)/dx by differences of step 1e-4.
    const Ritter flow(2, 9.81, 1000);
    const double c = std::sqrt(9.81 * 2), t = 1.5;
    double volume = 0;
    const int n = 100000;
    for (int k = 0; k < n; ++k) volume += flow.depth((k + 0.5) / n * 2 * c * t, t) * 2 * c * t / n;
    EXPECT_NEAR(volume, 8.0 / 27 * c * t * 2, 1e-7);
    const double d = 1e-4, x = 2.3;
    const auto flux = [&](double at) { return flow.depth(at, t) * flow.speed(at, t); };
    EXPECT_NEAR((flow.depth(x, t + d) - flow.depth(x, t - d)) / (2 * d) + (flux(x + d) - flux(x - d)) / (2 * d), 0, 1e-7);
    const double convection = (flow.speed(x, t + d) - flow.speed(x, t - d)) / (2 * d) +
                              flow.speed(x, t) * (flow.speed(x + d, t) - flow.speed(x - d, t)) / (2 * d);
    EXPECT_NEAR(convection + 9.81 * (flow.depth(x + d, t) - flow.depth(x - d, t)) / (2 * d), 0, 1e-7);
}

TEST(RotatingSquarePatch, agreesWithTheTabulatedSeries)
{
    // A double series computed independently; the profile on the middle line and the centre, in rho omega^2 L^2.
    const RotatingSquarePatch patch(2, 3, 1000);
    const double unit = 1000 * 9 * 4;
    const auto at = [&](double x, double y) { return patch.pressure({2 * (x - 0.5), 2 * (y - 0.5), 0}, 0) / unit; };
    EXPECT_NEAR(at(0.5, 0.5), -0.147343, 1e-6);
    EXPECT_NEAR(at(0.05, 0.5), -0.031335157148628, 1e-7);
    EXPECT_NEAR(at(0.15, 0.5), -0.0806466514012649, 1e-7);
    EXPECT_NEAR(at(0.5, 0.85), at(0.15, 0.5), 1e-7) << "the same along either side";
    EXPECT_EQ(at(0, 0.5), 0);
    EXPECT_EQ(at(1.2, 0.5), 0);
    // laplacian p = 2 rho omega^2, by differences of step 1e-3 of the side.
    const double h = 1e-3;
    EXPECT_NEAR((at(0.3 + h, 0.6) + at(0.3 - h, 0.6) + at(0.3, 0.6 + h) + at(0.3, 0.6 - h) - 4 * at(0.3, 0.6)) / (h * h), 2, 1e-4);
}

namespace
{
SuspensionChannel suspension(double mean, double phiMax, double exponent, double ratio)
{
    auto diagnostics = std::make_shared<Diagnostics>();
    const auto d = Dictionary::parse(fmt::format("width 2; phi {}; phiMax {}; exponent {}; ratio {}; mu 0.5; pressureGradient 3;", mean,
                                                 phiMax, exponent, ratio),
                                     "system/controlDict", diagnostics);
    const SuspensionChannel channel(d);
    d.reportUnused();
    EXPECT_EQ(errorsOf(*diagnostics), "");
    return channel;
}
}

// Wall and profile by an independent finite-volume solution to 6 digits, greatest speed times mu_0/(G h^2) to 6; eq. (4.1) of Kauzlaric et al. is
// closed: 12 digits.
TEST(SuspensionChannel, agreesWithTheTabulatedProfiles)
{
    struct Row
    {
        double mean, phiMax, exponent, ratio, wall, half, tenth, speed;
    };
    for (const auto& r : {Row{0.5492636344, 0.68, 1.82, 1 / (1 + 1 / 1.82), 0.45, 0.541593, 0.646934, 0.0419953},
                          Row{0.625, 0.794, 0.714, 0.4, 0.506412, 0.613823, 0.745906, 0.194901},
                          Row{0.625, 0.794, 0.714, 0.2, 0.571368, 0.614804, 0.687910, 0.181348},
                          Row{0.625, 0.794, 0.714, 0.1, 0.599789, 0.618799, 0.656359, 0.173722}})
    {
        const auto channel = suspension(r.mean, r.phiMax, r.exponent, r.ratio);
        EXPECT_NEAR(channel.wallPhi(), r.wall, 1e-6);
        EXPECT_NEAR(channel.phi(0.5), r.half, 1e-6);
        EXPECT_NEAR(channel.phi(0.1), r.tenth, 2e-6);
        EXPECT_NEAR(channel.phi(0), r.phiMax, 1e-9);
        EXPECT_NEAR(channel.speed(0) * 0.5 / 3, r.speed, 1e-6);
        EXPECT_NEAR(channel.velocity({7, 0.25, 0}, 0).x, channel.speed(0.75), 1e-15); // a quarter from one wall
        EXPECT_EQ(channel.speed(1), 0);
    }
    const auto channel = suspension(0.5492636344094383, 0.68, 1.82, 1 / (1 + 1 / 1.82));
    for (const double s : {0.0, 0.3, 0.9}) EXPECT_NEAR(channel.phi(s), 0.68 * 0.45 / (0.45 + s * (0.68 - 0.45)), 1e-7);
}

TEST(SuspensionChannel, mistakesNameFileAndLine)
{
    auto diagnostics = std::make_shared<Diagnostics>();
    SuspensionChannel(
        Dictionary::parse("width 2; phi 0.4; exponent 1; ratio 0.2;\nphiMax 5;\nnormal (1 1 0);", "system/controlDict", diagnostics));
    EXPECT_EQ(errorsOf(*diagnostics), "system/controlDict:2: 5 is no volume fraction\n"
                                      "system/controlDict:3: normal must be at right angles to direction, along which the flow goes\n"
                                      "2 errors");
}

// In a pipe: the mean over the section by itself, and half the speed of the plates' integral; the axis is where phi is largest.
TEST(SuspensionChannel, OfAPipeHasItsMeanOverTheSection)
{
    auto diagnostics = std::make_shared<Diagnostics>();
    const SuspensionChannel pipe(
        Dictionary::parse("section circular; width 2; phi 0.625; phiMax 0.794; exponent 0.714; ratio 0.2; mu 0.5; pressureGradient 3; "
                          "origin (0 5 7);",
                          "system/controlDict", diagnostics));
    EXPECT_EQ(errorsOf(*diagnostics), "");
    double mean = 0, speed = 0;
    const int parts = 20000;
    for (int k = 0; k < parts; ++k)
    {
        const double s = (k + 0.5) / parts;
        mean += 2 * s * pipe.phi(s) / parts;
        speed += 0.5 * s * std::pow(1 - pipe.phi(s) / 0.794, 0.714) / parts;
    }
    EXPECT_NEAR(mean, 0.625, 1e-7);
    EXPECT_NEAR(pipe.velocity({3, 5, 7}, 0).x, 3 / 0.5 * speed, 1e-6);
    EXPECT_NEAR(pipe.value({1, 5.3, 7.4}, 0), pipe.phi(0.5), 1e-14);
}
