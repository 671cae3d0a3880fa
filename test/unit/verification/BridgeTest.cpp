/// Liquid bridges: their shape at rest, and what is measured of one made of particles.
#include "Particles.hpp"
#include "base/CaseError.hpp"
#include "geometry/Sphere.hpp"
#include "sampling/Measurement.hpp"
#include "verification/CapillaryBridge.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace sph;

namespace
{
constexpr double degree = std::numbers::pi / 180;

struct Known
{
    int dimension;
    double gap, volume, contactAngle, halfFilling, curvature, neck, force;
};

/// Lattice particles between two solids of radius 1 and a gap of 1 along y; the bridge is all within `radius` of the line of centres, at
/// the given pressure.
Particles straightBridge(int dimension, double radius, double pressure)
{
    Particles particles(dimension, {-1.5, 0, -1.5}, {1.5, 3, 1.5}, 1.0 / 16);
    auto& g = particles.geometry;
    g.periodic = {true, true, dimension == 3};
    g.walls.resize(1);
    g.originals = {{std::make_shared<Sphere>(Vector<3>{0, 0, 0}, 1, FluidSide::outside), 0}};
    repeatPeriodically(g, 0.5);
    particles.phases = {"liquid", "gas"};
    particles.surfaceTension = 0.5;
    const auto inside = [=](const Vector<3>& x) { return std::hypot(x.x, dimension == 3 ? x.z : 0) < radius; };
    for (std::size_t i = 0; i < particles.size(); ++i)
        if (!g.inFluid(particles.position(i))) particles.x[i] = std::nan("");
    particles.setPhase([&](const Vector<3>& x) { return inside(x) ? 0 : 1; });
    particles.setP([&](const Vector<3>& x) { return inside(x) ? pressure : 2.0; });
    return particles;
}

const std::string parameters = "centres ((0 0 0) (0 3 0)); radius 1; contactAngle 60;";

Measurement measure(const Particles& particles, const std::string& name, const std::string& more = parameters)
{
    auto diagnostics = std::make_shared<Diagnostics>();
    const auto d = Dictionary::parse(more, "system/controlDict", diagnostics);
    const auto m = readMeasure(name, d, particles.geometry, particles.phases, ".");
    d.reportUnused();
    diagnostics->throwIfAny();
    return m(particles.view());
}
}

TEST(CapillaryBridge, AgreesWithAnIndependentIntegration)
{
    // By arc length with an adaptive step of 1e-11 (tutorials/stiff/liquidBridge/reference/bridges.csv); 400 steps along z are good to 1e-6.
    for (const Known& s : {Known{3, 1, 3, 60, 47.7334031, 1.5525018, 0.8775644, 1.7577754},
                           {3, 1, 3, 30, 57.4443151, 1.1623988, 0.8185054, 2.6963048},
                           {3, 0.05, 0.1, 30, 28.8239915, -1.3739948, 0.4394866, 3.5951072},
                           {3, 0.5, 1, 90, 34.8393440, 2.7525513, 0.7063105, 0.1239149},
                           {3, 0.5, 2, 120, 39.6784762, 2.8971440, 0.9564969, -2.3171243},
                           {2, 0.5, 0.75, 60, 35.7247979, 0.2276528, 0.6058010, 1.7241755},
                           {2, 0.5, 0.75, 30, 41.0453443, -0.6551297, 0.5738877, 2.7519417},
                           {2, 1, 2, 90, 39.8290556, 0.8749497, 0.9057044, 0.4151084}})
    {
        const double R = 2.7e-4;
        const CapillaryBridge bridge(s.dimension, R, s.gap * R, s.volume * std::pow(R, s.dimension), s.contactAngle);
        const auto name = ::testing::Message() << s.dimension << "-D, gap " << s.gap << ", volume " << s.volume << ", " << s.contactAngle;
        EXPECT_NEAR(bridge.halfFilling() / degree, s.halfFilling, 1e-5) << name;
        EXPECT_NEAR(bridge.curvature() * R, s.curvature, 2e-6) << name;
        EXPECT_NEAR(bridge.neck() / R, s.neck, 1e-6) << name;
        EXPECT_NEAR(bridge.force() / (s.dimension == 3 ? R : 1), s.force, 1e-5) << name;
    }
}

TEST(CapillaryBridge, OfCylindersIsAnArcOfACircle)
{
    // Values by hand: beta = 30 degrees, theta = 45: arcs of radius q = (gap/2 + 1 - cos beta)/cos(theta + beta), the neck q (1 - cos 15) inside sin beta. The
    // liquid between the contacts' chord less the segments of the solids and of the arcs.
    const double beta = 30 * degree, psi = 15 * degree, height = 0.25 + 1 - std::cos(beta), q = height / std::sin(psi);
    const double area =
        4 * height * std::sin(beta) - 2 * (beta - std::sin(beta) * std::cos(beta)) - 2 * q * q * (psi - std::sin(psi) * std::cos(psi));
    const CapillaryBridge bridge(2, 1, 0.5, area, 45);
    EXPECT_NEAR(bridge.halfFilling(), beta, 1e-7);
    EXPECT_NEAR(bridge.curvature(), -1 / q, 1e-7);
    EXPECT_NEAR(bridge.neck(), std::sin(beta) - q * (1 - std::cos(psi)), 1e-7);
}

TEST(CapillaryBridge, ThatDoesNotSpanTheGapIsAnError)
{
    try
    {
        CapillaryBridge(3, 1, 1, 0.1, 40);
        FAIL();
    }
    catch (const CaseError& error)
    {
        EXPECT_STREQ(error.what(), "no bridge of 0.1 m^3 at 40 degrees spans the gap of 1 m between spheres of radius 1 m");
    }
}

TEST(LiquidBridge, OfParticlesHasItsNeckAndPressure)
{
    // Cut out of a lattice of 16 to the radius: the staircase leaves the neck within a third of a spacing. The pressures are uniform: round-off.
    for (const int dimension : {2, 3})
    {
        const double radius = 0.8;
        const auto particles = straightBridge(dimension, radius, 5);
        double volume = 0;
        for (std::size_t i = 0; i < particles.size(); ++i)
            if (particles.phase[i] == 0) volume += particles.mass[i] / 1000;
        const CapillaryBridge exact(dimension, 1, 1, volume, 60);
        const auto neck = measure(particles, "bridgeNeck"), pressure = measure(particles, "bridgePressure");
        EXPECT_NEAR(neck.value, radius, 0.02) << dimension;
        EXPECT_NEAR(neck.reference, exact.neck(), 1e-12);
        EXPECT_NEAR(pressure.value, 3, 1e-12) << dimension;
        EXPECT_NEAR(pressure.reference, 0.5 * exact.curvature(), 1e-12);
        EXPECT_GT(pressure.particles, 0);
        const auto force = measure(particles, "bridgeForce");
        const double r = neck.value;
        EXPECT_NEAR(force.value, dimension == 3 ? 2 * std::numbers::pi * r * 0.5 - std::numbers::pi * r * r * 3 : 2 * 0.5 - 2 * r * 3,
                    1e-11);
        EXPECT_NEAR(force.reference, 0.5 * exact.force(), 1e-12);
        // Of an eighth, or of the liquid alone, the reference is known.
        const CapillaryBridge larger(dimension, 1, 1, 1.5 * volume, 60);
        EXPECT_NEAR(measure(particles, "bridgeNeck", parameters + " parts 1.5;").reference, larger.neck(), 1e-9);
    }
}

// The pressure of one particle deep in the bridge, and of one in the gas far from it.
TEST(LiquidBridge, ShowsANaN)
{
    for (const double x : {0.03125, 1.46875})
    {
        auto particles = straightBridge(2, 0.8, 5);
        std::size_t changed = 0;
        for (std::size_t i = 0; i < particles.size(); ++i)
            if (std::fabs(particles.x[i] - x) < 1e-9 && std::fabs(particles.y[i] - 1.53125) < 1e-9)
            {
                particles.p[i] = std::nan("");
                ++changed;
            }
        EXPECT_EQ(changed, 1u);
        EXPECT_TRUE(std::isnan(measure(particles, "bridgePressure").value)) << x;
    }
}

TEST(LiquidBridge, ThatIsBrokenHasNoNeck)
{
    auto particles = straightBridge(2, 0.8, 5);
    particles.setPhase([](const Vector<3>& x) { return std::fabs(x.x) < 0.8 && std::fabs(x.y - 1.5) > 0.3 ? 0 : 1; });
    const auto neck = measure(particles, "bridgeNeck");
    EXPECT_TRUE(std::isnan(neck.value));
    EXPECT_EQ(neck.note, "midway between the solids there is no bridge with a surface all round");
}

TEST(LiquidBridge, MistakesAreNamed)
{
    const auto particles = straightBridge(2, 0.8, 5);
    const auto mistake = [&](const std::string& text)
    {
        try
        {
            measure(particles, "bridgeNeck", text);
        }
        catch (const CaseError& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(mistake("centres ((0 0 0) (0 1.5 0));\nradius 1; contactAngle 60;"),
              "system/controlDict:1: the centres are 1.5 m apart, less than two radii: there is no gap for a bridge");
    EXPECT_EQ(mistake("radius 1; contactAngle 60;\ncentres ((0 0 0));"), "system/controlDict:2: a bridge has two centres, not 1");
    EXPECT_EQ(mistake("centres ((0 0 0) (0 3 0)); radius 1;\ncontactAngle 190;"),
              "system/controlDict:2: a liquid forms a bridge where its contact angle lies between 0 and 180 degrees");
    // Errors that only the particles tell: too little liquid for the gap, and no tension at all.
    EXPECT_EQ(mistake("centres ((0 0 0) (0 30 0)); radius 1; contactAngle 60;").find("system/controlDict:1: no bridge of "), 0u);
    auto slack = particles;
    slack.surfaceTension = 0;
    EXPECT_THROW(measure(slack, "bridgeNeck"), CaseError);
    EXPECT_THROW(measure(slack, "bridgePressure"), CaseError);
}
