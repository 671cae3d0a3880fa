/// The work of walls in motion and of openings, which closes the energy balance of their scenes.
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
    return simulation.energy().measuredWork;
}

double whole(const Energy& energy) { return energy.kinetic + energy.allStored(); }

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
TEST(BoundaryWork, IsThatOfShearBetweenPlates)
{
    for (const char* scheme : {"predictorCorrector", "semiImplicit"})
    {
        SCOPED_TRACE(scheme);
        EXPECT_NEAR(powerOfPlates("0", "1", scheme), 1000, 10);
        EXPECT_NEAR(powerOfPlates("-0.5", "0.5", scheme), 1000, 10);
    }
}

// A lid that comes down upon a fluid without viscosity: all of its work is kinetic and elastic energy.
TEST(BoundaryWork, OfAPistonIsStored)
{
    CaseScene scene(boxOf(
        "}\nwalls { bottom { type plane; point (0 0 0); normal (0 1 0); } left { type plane; point (0 0 0); normal (1 0 0); } right { "
        "type plane; point (1 0 0); normal (-1 0 0); } top { type plane; point (0 1 0); normal (0 -1 0); velocity (0 -0.15 0); } }\n",
        "mu 0; soundSpeed 15;", "wallVelocity freeSlip;\nintegration { scheme leapfrog; }\n"));
    ASSERT_EQ(scene.errors, "");
    const auto before = scene.simulation->energy();
    const double work = advance(*scene.simulation, 0, 0.2), gained = whole(scene.simulation->energy()) - whole(before);
    EXPECT_GT(work, 0.5 * 1000 * 225 * 0.03 * 0.03 * 0.9); // that of a slow one: rho c^2 d^2/2, d = 0.03
    EXPECT_NEAR(gained, work, 0.02 * work);
}

/// Between an inlet and an outlet without pressure, 1 m apart, whose fluid is held 0.4 m beyond.
Files ductOf(const std::string& walls, const std::string& fluid, const std::string& inlet, const std::string& schemes)
{
    auto files = boxOf(walls, fluid, schemes);
    auto& geometry = files["constant/geometry"];
    geometry.replace(geometry.find("min (0 0 0); max (1 1 0)"), 24, "min (-0.4 0 0); max (1.4 1 0)");
    files["constant/openings"] = "in { type inlet; point (0 0 0); normal (1 0 0); " + inlet + " }\n" +
                                 "out { type outlet; point (1 0 0); normal (-1 0 0); pressure 0; }\n";
    return files;
}

// Water at rest, without viscosity, that an inlet of 0.2 m/s begins to push: a front of rho c U runs to the outlet in 0.067 s, and comes back without
// pressure. At each moment the water has what the openings have given; a particle of the first row passes the plane at once, 3 % of the least energy.
TEST(BoundaryWork, OfOpeningsIsStored)
{
    for (const char* density : {"", "density continuity;\n"})
    {
        SCOPED_TRACE(density);
        CaseScene scene(ductOf("periodic (y); }\n", "mu 0; soundSpeed 15;", "velocity 0.2; profile uniform;",
                               std::string(density) + "integration { scheme leapfrog; }\n"));
        ASSERT_EQ(scene.errors, "");
        const double before = whole(scene.simulation->energy());
        double work = 0, time = 0;
        for (const double next : {0.02, 0.04, 0.06, 0.08, 0.1, 0.12, 0.14})
        {
            work = advance(*scene.simulation, time, next);
            time = next;
            EXPECT_NEAR(whole(scene.simulation->energy()) - before, work, 0.02 * work + 0.1) << time;
        }
        EXPECT_NEAR(work, 76, 4);
    }
}

// Developed flow between walls, 12 mu U^2/h^2 per area: what the inlet gives beyond what the outlet takes.
TEST(BoundaryWork, OfOpeningsIsDissipated)
{
    CaseScene scene(
        ductOf("}\nwalls { bottom { type plane; point (0 0 0); normal (0 1 0); } top { type plane; point (0 1 0); normal (0 -1 0); } }\n",
               "mu 1000; soundSpeed 15;", "velocity 0.2; profile developed;", "wallVelocity secondOrder;\n"));
    ASSERT_EQ(scene.errors, "");
    const double before = advance(*scene.simulation, 0, 1);
    EXPECT_NEAR(advance(*scene.simulation, 1, 2) - before, 480, 0.02 * 480);
}

// What nobody asks for is not measured: no group, no field.
TEST(BoundaryWork, IsLeftOutWithoutABalance)
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
    files = ductOf("periodic (y); }\n", "mu 1; soundSpeed 15;", "velocity 0.2;", "backgroundPressure 10;\n");
    EXPECT_FALSE(measures()); // nor what the balance would not be of
}

}
