/// Forces on walls, which are what walls give to the momentum of the scene, and nothing else.
#include "CaseScene.hpp"
#include "case/forcesOnWalls.hpp"
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

/// Soil or fluid in a box of 1 m under gravity, with the function object.
Files filled(const std::string& stress, const std::string& patches)
{
    auto files = channelCase();
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (1 -10 0);\n";
    files["system/controlDict"] += "functions { load { type forces; patches (" + patches + "); } }\n";
    files["constant/geometry"] =
        "dimension 2; domain { min (0 0 0); max (1 1.4 0); }\nwalls { floor { type plane; point (0 0 0); normal (0 1 0); } left { type plane; "
        "point (0 0 0); normal (1 0 0); slip yes; } right { type plane; point (1 0 0); normal (-1 0 0); } footing { type box; min (0.35 1 0); "
        "max (0.65 1.4 0); fluid outside; velocity (0 -0.1 0); } }\n";
    files["constant/phaseProperties"] = "phases (water);\nwater { rho 1000; " + stress + " }\n";
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 3; kernel wendlandC2; }\n";
    return files;
}

Vector<3> forceOn(const AnySimulation& simulation, const std::string& wall)
{
    const auto numbers = simulation.summary().columns;
    return {numbers.at(forceOnWall(wall, 0)), numbers.at(forceOnWall(wall, 1)), numbers.at(forceOnWall(wall, 2))};
}

}

// dP/dt = m g - sum F over each step, to round-off: of a fluid and of soil, with a body that moves and corners of two walls, before a particle touches one.
TEST(WallForces, AreTheRateOfMomentum)
{
    for (const std::string stress : {"mu 1; soundSpeed 30;", "stress constitutiveLaw;"})
    {
        SCOPED_TRACE(stress);
        auto files = filled(stress, "floor left right footing");
        if (stress[0] == 's') files["constant/soilProperties"] = "rho 1000; law elastic; elasticCoeffs { E 1e6; nu 0.3; }\n";
        else files["system/sphSchemes"] += "integration { scheme symplecticEuler; }\n";
        CaseScene scene(files);
        ASSERT_EQ(scene.errors, "");
        auto& simulation = *scene.simulation;
        const double deltaT = 0.5 * simulation.stepLimit().deltaT;
        for (int k = 0; k < 20; ++k)
        {
            const auto before = simulation.summary();
            simulation.step(k * deltaT, deltaT);
            const auto after = simulation.summary();
            Vector<3> walls;
            for (const char* wall : {"floor", "left", "right", "footing"}) walls += forceOn(simulation, wall);
            const auto gained = after.momentum - before.momentum, given = deltaT * (before.force - walls);
            ASSERT_NEAR(gained.x, given.x, 1e-9 * deltaT * mag(before.force)) << k;
            ASSERT_NEAR(gained.y, given.y, 1e-9 * deltaT * mag(before.force)) << k;
        }
        EXPECT_GT(std::abs(forceOn(simulation, "footing").y), 1) << "the footing touches it";
    }
}

// A wall that the case has not is named with its line, and pressure within the step has no forces of one evaluation.
TEST(WallForces, SayWhatTheyCannot)
{
    auto files = filled("mu 1; soundSpeed 30;", "floor");
    files["system/sphSchemes"] += "integration { scheme implicit; }\n";
    EXPECT_NE(CaseScene(files).errors.find("there are none with pressure within the step"), std::string::npos);
}

}
