/// The work of walls in motion, which closes the energy balance of their scenes.
#include "CaseScene.hpp"
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

const std::string balance = "functions { sums { type conservation; } }\n";

/// A fluid of 1000 kg/m^3 in a box or a channel, at rest, without gravity.
Files boxOf(const std::string& geometry, const std::string& fluid, const std::string& schemes)
{
    auto files = channelCase();
    files.erase("constant/g");
    files["system/controlDict"] += balance;
    files["constant/geometry"] = "dimension 2; domain { min (0 0 0); max (1 1 0); " + geometry;
    files["constant/phaseProperties"] = "phases (water);\nwater { rho 1000; " + fluid + " }\n";
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 3; kernel wendlandC2; }\n" + schemes;
    return files;
}

double advance(AnySimulation& simulation, double from, double to)
{
    while (from < to)
    {
        const double deltaT = std::min(simulation.stepLimit().deltaT, to - from);
        simulation.step(from, deltaT);
        from += deltaT;
    }
    return simulation.energy().work;
}

/// Mean power between plates 1 m apart that slide with these velocities, between 0.8 and 0.9 s of 1 m^2/s, steady but for 4e-4.
double powerOfPlates(const std::string& lower, const std::string& upper, const std::string& scheme)
{
    CaseScene scene(boxOf("periodic (x); }\nwalls { bottom { type plane; point (0 0 0); normal (0 1 0); velocity (" + lower +
                              " 0 0); } top { type plane; point (0 1 0); normal (0 -1 0); velocity (" + upper + " 0 0); } }\n",
                          "mu 1000; soundSpeed 15;", "wallVelocity secondOrder;\nintegration { scheme " + scheme + "; }\n"));
    EXPECT_EQ(scene.errors, "");
    const double before = advance(*scene.simulation, 0, 0.8);
    return (advance(*scene.simulation, 0.8, 0.9) - before) / 0.1;
}

}

// mu U^2/h per area, whichever of the plates moves.
TEST(WallWork, IsThatOfShearBetweenPlates)
{
    for (const char* scheme : {"predictorCorrector", "semiImplicit"})
    {
        SCOPED_TRACE(scheme);
        EXPECT_NEAR(powerOfPlates("0", "1", scheme), 1000, 10);
        EXPECT_NEAR(powerOfPlates("-0.5", "0.5", scheme), 1000, 10);
    }
}

// A lid that comes down upon a fluid without viscosity: all of its work is kinetic and elastic energy.
TEST(WallWork, OfAPistonIsStored)
{
    CaseScene scene(boxOf(
        "}\nwalls { bottom { type plane; point (0 0 0); normal (0 1 0); } left { type plane; point (0 0 0); normal (1 0 0); } right { "
        "type plane; point (1 0 0); normal (-1 0 0); } top { type plane; point (0 1 0); normal (0 -1 0); velocity (0 -0.15 0); } }\n",
        "mu 0; soundSpeed 15;", "wallVelocity freeSlip;\nintegration { scheme leapfrog; }\n"));
    ASSERT_EQ(scene.errors, "");
    const auto before = scene.simulation->energy();
    const double work = advance(*scene.simulation, 0, 0.2);
    const auto after = scene.simulation->energy();
    const double gained = after.kinetic + after.allStored() - before.kinetic - before.allStored();
    EXPECT_GT(work, 0.5 * 1000 * 225 * 0.03 * 0.03 * 0.9); // that of a slow one: rho c^2 d^2/2, d = 0.03
    EXPECT_NEAR(gained, work, 0.02 * work);
}

// What nobody asks for is not measured: no group, no field.
TEST(WallWork, IsLeftOutWithoutABalance)
{
    auto files = boxOf(
        "periodic (x); }\nwalls { bottom { type plane; point (0 0 0); normal (0 1 0); } top { type plane; point (0 1 0); normal (0 -1 0); velocity (1 "
        "0 0); } }\n",
        "mu 1000; soundSpeed 15;", "");
    const auto measures = [&] { return CaseScene(files).settings.facts.get<BoundaryPower>().isMeasured; };
    EXPECT_TRUE(measures());
    auto& control = files["system/controlDict"];
    control.replace(control.find(balance), balance.size(), "");
    EXPECT_FALSE(measures());
}

}
