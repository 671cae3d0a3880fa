/// What a run holds in energy and what its scene can have supplied.
#include "solver/EnergyBalance.hpp"
#include "periodicSquare.hpp"
#include "solver/Simulation.hpp"
#include <cmath>
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

constexpr double spacing = 0.05, gamma = 3;

/// A lattice that moves as a whole; the lower half is of the second phase where there are two.
Cloud lattice(Vector<3> U, bool twoPhases)
{
    Cloud cloud;
    auto &velocity = cloud.fields["U"], &phase = cloud.fields["phase"];
    velocity.type = FieldClass::vector;
    velocity.component.resize(3);
    phase.component.resize(1);
    for (int a = 0; a < 20; ++a)
        for (int b = 0; b < 20; ++b)
        {
            cloud.x.push_back((a + 0.5) * spacing);
            cloud.y.push_back((b + 0.5) * spacing);
            cloud.z.push_back(0);
            for (const auto& [c, u] : {std::pair(0, U.x), {1, U.y}, {2, U.z}}) velocity.component[std::size_t(c)].push_back(u);
            phase.component[0].push_back(twoPhases && b < 10);
        }
    return cloud;
}

Settings settingsOfPhases(const std::string& phaseProperties, const std::string& more)
{
    auto files = channelCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 3; kernel wendlandC2; }\nintegration { scheme symplecticEuler; }\n" + more;
    files["constant/phaseProperties"] = phaseProperties;
    files.erase("constant/g");
    return settingsOf(files);
}

const std::string waterAndAir =
    "phases (water air);\nwater { rho 1000; mu 0; soundSpeed 10; }\nair { rho 1; mu 0; soundSpeed 10; }\nsigma ( (water air) 3 );\n";
}

TEST(EnergyBalance, CountsTheAreaOfPlaneInterfaces)
{
    // Two interfaces of length 1 between strips. The sum over pairs on a lattice of three spacings to the support is 5.6 % below the integral.
    const auto settings = settingsOfPhases(waterAndAir, "");
    const auto g = periodicSquare();
    const auto simulation = makeSimulation(settings, g, lattice({0, 0, 0}, true), {});
    EXPECT_NEAR(simulation->energy().held(), 2 * gamma, 0.06 * 2 * gamma);
    EXPECT_GT(simulation->energy().supplied, simulation->energy().held());
}

TEST(EnergyBalance, KnowsNoInterfaceWithoutTension)
{
    const auto settings = settingsOfPhases(waterAndAir, "surfaceTension none; pressureGradient densityWeighted;");
    const auto g = periodicSquare();
    const auto simulation = makeSimulation(settings, g, lattice({0, 2, 0}, true), {});
    EXPECT_NEAR(simulation->energy().held(), 0.5 * (500 + 0.5) * 4, 1e-9);
}

TEST(EnergyBalance, IsSuppliedByTheWorkOfABodyForce)
{
    // A fluid that falls freely and as a whole: what it gains is what the force has done, step by step, to round-off.
    const auto settings = settingsOfPhases("phases (water);\nwater { rho 1000; mu 0; soundSpeed 10; }\nbodyForce (5000 -2000 0);\n", "");
    const auto g = periodicSquare();
    const auto simulation = makeSimulation(settings, g, lattice({0.1, 0, 0}, false), {});
    const auto before = simulation->energy();
    EXPECT_NEAR(before.held(), 0.5 * 1000 * 0.01, 1e-9);
    for (int k = 0; k < 20; ++k) simulation->step(0, 1e-3);
    const auto after = simulation->energy();
    EXPECT_NEAR(after.held(), 0.5 * 1000 * (0.2 * 0.2 + 0.04 * 0.04), 1e-6);
    EXPECT_NEAR(after.supplied - before.supplied, after.held() - before.held(), 1e-6);
    EXPECT_NEAR(after.measuredWork, after.kinetic - before.kinetic, 1e-6);
    EXPECT_NEAR(after.impulse.x, 5000 * 0.02, 1e-9);
    EXPECT_NEAR(after.impulse.y, -2000 * 0.02, 1e-9);
}

// A sink is never named as the source.
TEST(EnergyBalance, NamesTheLargestPositiveWorkAsTheSource)
{
    EXPECT_EQ(sourceInWords({{"gravity", 0.5}, {"pressure", 2}, {"viscosity", -3}}),
              "what feeds it is pressure: work of pressure 2 J, gravity 0.5 J, viscosity -3 J");
    EXPECT_EQ(sourceInWords({{"pressure", -0.0216}, {"viscosity", -0.5}}),
              "no operation feeds it any more, each takes energy: work of pressure -0.0216 J, viscosity -0.5 J");
}

TEST(EnergyBalance, KnowsWhatIsStoredByCompression)
{
    // At rest density nothing; where the density is higher by a share d of itself, rho c^2 d^2/2 a volume within some d of itself (Tait's
    // law, n = 7).
    auto files = channelCase();
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 3; }\ndensity continuity;\nintegration { scheme leapfrog; }\n";
    files["constant/phaseProperties"] = "phases (water);\nwater { rho 1000; mu 0; soundSpeed 10; }\n";
    files.erase("constant/g");
    const auto settings = settingsOf(files);
    const auto g = periodicSquare();
    const auto compression = [&](double rho)
    {
        auto cloud = lattice({0, 0, 0}, false);
        cloud.fields["rho"].component.assign(1, std::vector<double>(cloud.x.size(), rho));
        return makeSimulation(settings, g, cloud, {})->energy().stored.at(0).value;
    };
    EXPECT_NEAR(compression(1000), 0, 1e-12);
    EXPECT_NEAR(compression(1010), 1000 * 100 * 0.01 * 0.01 / 2, 0.02 * 5);
}

TEST(EnergyBalance, IsNotBlindedByAUniformPressure)
{
    // The same everywhere, a pressure moves nothing, however large: 1/2 M (c/100)^2 and 0.02 of a twentieth of rho c^2 are all that it is allowed,
    // and a fluid at a fifth of its sound speed holds five times as much.
    const auto settings = settingsOfPhases("phases (water);\nwater { rho 1000; mu 0; soundSpeed 10; }\n", "backgroundPressure 1e12;\n");
    const auto g = periodicSquare();
    const auto simulation = makeSimulation(settings, g, lattice({0, 0, 0}, false), {});
    EXPECT_NEAR(simulation->energy().supplied, 0.5 * 1000 * 0.01 + 0.02 * 0.05 * 1000 * 100, 0.1);
}

TEST(EnergyBalance, AllowsForSoundOfAHundredthOfItsSpeed)
{
    // Nothing moves, nothing can: what is left is 1/2 M (c/100)^2.
    const auto settings = settingsOfPhases("phases (water);\nwater { rho 1000; mu 0; soundSpeed 10; }\n", "");
    const auto g = periodicSquare();
    const auto simulation = makeSimulation(settings, g, lattice({0, 0, 0}, false), {});
    EXPECT_EQ(simulation->energy().held(), 0);
    EXPECT_NEAR(simulation->energy().supplied, 0.5 * 1000 * 0.01, 1e-6);
}

}
