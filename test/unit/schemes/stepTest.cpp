/// The step itself: its order in time, and what it keeps.
#include "Simulation.hpp"
#include "smallCases.hpp"
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test
{
namespace
{

Geometry periodicSquare()
{
    Geometry g;
    g.dimension = 2;
    g.high = {1, 1, 0};
    g.periodic = {true, true, false};
    return g;
}

/// 20 x 20 particles in a doubly periodic square, a Taylor-Green vortex between two viscous phases or in one.
Cloud vortex(bool twoPhases)
{
    Cloud cloud;
    const double k = 2 * std::numbers::pi;
    auto &U = cloud.fields["U"], &phase = cloud.fields["phase"];
    U.type = FieldClass::vector;
    U.component.resize(3);
    phase.component.resize(1);
    for (int a = 0; a < 20; ++a)
        for (int b = 0; b < 20; ++b)
        {
            const double x = (a + 0.5) / 20, y = (b + 0.5) / 20;
            cloud.x.push_back(x);
            cloud.y.push_back(y);
            cloud.z.push_back(0);
            U.component[0].push_back(std::sin(k * x) * std::cos(k * y));
            U.component[1].push_back(-std::cos(k * x) * std::sin(k * y));
            U.component[2].push_back(0);
            phase.component[0].push_back(twoPhases && b < 10);
        }
    return cloud;
}

Settings settingsOf(const Files& files)
{
    const TestCase folder(files);
    const Case c(folder.folder());
    auto settings = readSettings(c, periodicSquare());
    c.diagnostics().throwIfAny();
    return settings;
}

Files vortexCase(const std::string& integrator)
{
    auto files = channelCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 2.6; kernel wendlandC4; }\nintegration { scheme " + integrator + "; }\n";
    files["constant/phaseProperties"] = "phases (water);\nwater { rho 1000; mu 20; soundSpeed 8; exponent 1; }\n";
    files.erase("constant/g");
    return files;
}

/// All velocities after 0.02 s in n steps, in the order of the particles' masses, which number them.
std::vector<double> velocities(const Settings& settings, int steps)
{
    const auto g = periodicSquare();
    auto cloud = vortex(false);
    auto& m = cloud.fields["m"].component;
    m.resize(1);
    for (std::size_t i = 0; i < cloud.size(); ++i) m[0].push_back(2.5 * (1 + 1e-12 * double(i)));
    const auto simulation = makeSimulation(settings, g, cloud, {{"densityScale", 1.0}});
    for (int k = 0; k < steps; ++k) simulation->step(0, 0.02 / steps);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < simulation->size(); ++i) order.emplace_back(simulation->field("m").component[0][i], i);
    std::sort(order.begin(), order.end());
    std::vector<double> all;
    for (const auto& [_, i] : order)
        for (int c = 0; c < 2; ++c) all.push_back(simulation->field("U").component[std::size_t(c)][i]);
    return all;
}

double distance(const std::vector<double>& a, const std::vector<double>& b)
{
    double sum = 0;
    for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return std::sqrt(sum / double(a.size()));
}

/// Order from three runs, each with half the step of the one before: log2(|v1 - v2|/|v2 - v4|). Lists are rebuilt at moments
/// that depend on the step, which changes only the order of sums.
double observedOrder(const std::string& integrator)
{
    const auto settings = settingsOf(vortexCase(integrator));
    const auto coarse = velocities(settings, 40), middle = velocities(settings, 80), fine = velocities(settings, 160);
    return std::log2(distance(coarse, middle) / distance(middle, fine));
}
// Within 0.2 of the order that the scheme's algebra gives: steps of 1/4 to 1/16 of the sound limit are near, not in, the limit
// of small steps.
TEST(Step, PredictorCorrectorIsOfSecondOrder) { EXPECT_NEAR(observedOrder("predictorCorrector"), 2, 0.2); }
TEST(Step, LeapfrogIsOfSecondOrder) { EXPECT_NEAR(observedOrder("leapfrog"), 2, 0.2); }
TEST(Step, SymplecticEulerIsOfFirstOrderInViscosity) { EXPECT_NEAR(observedOrder("symplecticEuler"), 1, 0.2); }

// Two phases with viscosity and surface tension in a periodic box, 200 steps: the mass of each phase stays the same number, and
// momentum stays at the round-off of 200 x 400 x 24 pair forces against the sum of |m v|, however the lists are rebuilt and the
// particles sorted.
TEST(Step, ConservesMassOfEachPhaseAndMomentum)
{
    for (const char* integrator : {"predictorCorrector", "leapfrog", "symplecticEuler"})
    {
        SCOPED_TRACE(integrator);
        auto files = vortexCase(integrator);
        files["constant/phaseProperties"] =
            "phases (water oil);\nwater { rho 1000; mu 20; soundSpeed 15; }\noil { rho 800; mu 30; soundSpeed 15; }\nsigma ( "
            "(water oil) 20 );\n";
        const auto settings = settingsOf(files);
        const auto g = periodicSquare();
        const auto simulation = makeSimulation(settings, g, vortex(true), {});
        const auto before = simulation->summary();
        for (int k = 0; k < 200; ++k) simulation->step(0, simulation->stepLimit().deltaT);
        const auto after = simulation->summary();
        EXPECT_GT(simulation->rebuilds(), 5);
        ASSERT_EQ(after.mass.size(), 2u);
        for (std::size_t k = 0; k < 2; ++k)
        {
            EXPECT_EQ(after.count[k], before.count[k]);
            EXPECT_NEAR(after.mass[k] / before.mass[k], 1, 1e-13);
        }
        EXPECT_GT(mag(after.momentum), 0);
        EXPECT_LT(mag(after.momentum - before.momentum), 1e-11 * 900) << "kg m/s in 2-D; the box holds 900 kg at about 0.5 m/s";
        EXPECT_LT(after.kineticEnergy, before.kineticEnergy);
    }
}

}

/// x of all particles, over the edge of the square, after 20 steps: `edge` [m] scales lengths, times and the viscosity, so that all
/// numbers of the flow stay what they are.
std::vector<double> travelled(double edge, double shifting)
{
    auto files = vortexCase("symplecticEuler");
    const auto number = [](double q) { return std::to_string(q); };
    files["system/sphSchemes"] = "resolution { spacing " + number(0.05 * edge) + "; support 2.6; kernel wendlandC4; }\nshifting " +
                                 number(shifting) + ";\nintegration { scheme symplecticEuler; }\n";
    files["constant/phaseProperties"] = "phases (water);\nwater { rho 1000; mu " + number(20 * edge) + "; soundSpeed 8; exponent 1; }\n";
    auto g = periodicSquare();
    g.high *= edge;
    auto cloud = vortex(false);
    for (auto* x : {&cloud.x, &cloud.y})
        for (double& q : *x) q *= edge;
    const TestCase folder(files);
    const Case c(folder.folder());
    const auto settings = readSettings(c, g);
    c.diagnostics().throwIfAny();
    const auto simulation = makeSimulation(settings, g, cloud, {{"densityScale", 1.0}});
    for (int k = 0; k < 20; ++k) simulation->step(0, 0.002 * edge);
    std::vector<double> x;
    for (std::size_t i = 0; i < simulation->size(); ++i) x.push_back(simulation->positions().component[0][i] / edge);
    return x;
}

// Shifting is a length: C |v| dt Delta_x times a number of the particles' arrangement. All numbers are scaled by a power of two, so that
// only round-off of the kernel's constants is left.
TEST(Step, ShiftingScalesWithTheSpacing)
{
    const auto small = travelled(1, 2), large = travelled(16, 2), unshifted = travelled(1, 0);
    EXPECT_GT(distance(small, unshifted), 1e-4);
    EXPECT_LT(distance(small, large), 1e-12);
}

}
