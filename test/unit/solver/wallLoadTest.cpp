/// Walls that go by a load: soil and water beneath one carry it, a wall that is too light for what it pushes is named, so are mistakes.
#include "CaseScene.hpp"
#include "case/forcesOnWalls.hpp"
#include "messages.hpp"
#include "runTo.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

/// A column 0.5 m wide and 1 m high between walls that slip, beneath a lid; of soil, E_oed 1e7 Pa, or of a fluid.
struct Press
{
    std::string load = "force 500; direction (0 -1 0); mass 100;", ofLid = "", more = "";
    bool isSoil = true;

    Files files() const
    {
        auto files = soilCase();
        files.erase("constant/g");
        files["constant/geometry"] = fmt::format(
            "dimension 2; domain {{ min (0 0 0); max (0.5 1 0); }}\nwalls {{ base {{ type plane; point (0 0 0); normal (0 1 0); slip yes; }} "
            "left {{ type plane; point (0 0 0); normal (1 0 0); slip yes; }} right {{ type plane; point (0.5 0 0); normal (-1 0 0); slip yes; }} "
            "lid {{ type plane; point (0 1 0); normal (0 -1 0); slip yes; load {{ {} }} {} }} }}\n",
            load, ofLid);
        files["system/sphSchemes"] = "resolution { spacing 0.1; support 3; kernel wendlandC2; }\n" + more;
        files["constant/phaseProperties"] = isSoil ? "phases (soil);\nsoil { rho 2000; stress constitutiveLaw; }\n"
                                                   : "phases (water);\nwater { rho 2000; mu 100; soundSpeed 30; }\n";
        files["constant/soilProperties"] =
            "rho 2000;\nlaw elastic;\nelasticCoeffs { E 7.428571428571429e6; nu 0.3; }\ninitialStress { type isotropic; pressure 0; }\n";
        if (!isSoil) files.erase("constant/soilProperties");
        return files;
    }
};

double sunk(const AnySimulation& simulation) { return -simulation.summary().columns.at(displacementOfWall("lid", 1)); }

}

// It sinks by F H/(A E_oed), 1e-4 of the height, and the soil answers with the load; as light as the row of particles beneath it may be.
TEST(WallLoad, IsCarriedBySoil)
{
    auto load = Press{};
    load.load += " damping 200;";
    const CaseScene scene(load.files());
    ASSERT_EQ(scene.errors, "");
    runTo(*scene.simulation, 0.5);
    EXPECT_NEAR(sunk(*scene.simulation), 1e-4, 1e-6);
    EXPECT_NEAR(scene.simulation->summary().columns.at(forceOnWall("lid", 1)), 500, 0.5);
}

// F/A = rho c^2 (rho/rho_0 - 1) beneath a piston: it sinks by F H/(A rho_0 c^2).
TEST(WallLoad, IsCarriedByAFluid)
{
    const CaseScene scene(Press{.load = "force 4500; direction (0 -1 0); mass 200; damping 100;",
                                .more = "integration { scheme symplecticEuler; }",
                                .isSoil = false}
                              .files());
    ASSERT_EQ(scene.errors, "");
    runTo(*scene.simulation, 1);
    EXPECT_NEAR(sunk(*scene.simulation), 0.005, 0.0003);
    EXPECT_NEAR(scene.simulation->summary().columns.at(forceOnWall("lid", 1)), 4500, 45);
}

// m dv/dt = F - m c v, with nothing beneath it: F of the middle of each step, c at its end.
TEST(WallLoad, MovesAWallThatPushesNothing)
{
    auto away = Press{.load = "force \"400*$t\"; direction (0 2 0); mass 100; damping 3;"}.files();
    away["constant/geometry"].replace(away["constant/geometry"].find("point (0 1 0)"), 13, "point (0 2 0)");
    const CaseScene scene(away);
    ASSERT_EQ(scene.errors, "");
    const double deltaT = 1e-3;
    for (int k = 0; k < 100; ++k) scene.simulation->step(k * deltaT, deltaT);
    // 4 t = dv/dt + 3 v: v = 4/3 t - 4/9 (1 - exp(-3 t))
    const double t = 0.1, gone = 2.0 / 3 * t * t - 4.0 / 9 * t + 4.0 / 27 * (1 - std::exp(-3 * t));
    EXPECT_NEAR(-sunk(*scene.simulation), gone, 0.01 * gone);
}

// Water in the pores of a slab that may leave at its side moves at once with the lid: a light one would be thrown to and fro.
TEST(WallLoad, IsNotThrownToAndFro)
{
    auto files = Press{.load = "force 500; direction (0 -1 0); mass 180;"}.files();
    files["constant/soilProperties"] += "poreWater { permeability 1e-4; porosity 0.4; bulkModulus 2.2e9; }\n";
    auto& geometry = files["constant/geometry"];
    geometry.replace(geometry.find("right {"), geometry.find("lid {") - geometry.find("right {"), "");
    geometry.replace(geometry.find("max (0.5"), 8, "max (0.9");
    const CaseScene scene(files);
    ASSERT_EQ(scene.errors, "");
    const auto error = messageOf([&] { runTo(*scene.simulation, 0.5); });
    EXPECT_PRED2(says, error, "wall \"lid\" under load and what it pushes throw one another to and fro");
}

TEST(WallLoad, SaysWhatIsWrong)
{
    const auto errorOf = [](const Press& press)
    {
        std::string error;
        const auto thrown = messageOf([&] { error = CaseScene(press.files()).errors; });
        return error + thrown;
    };
    EXPECT_PRED2(says, errorOf({.load = "force 1; direction (0 -1 0); mass 90;"}),
                 "less than the 100 kg of the particles within a spacing of it");
    EXPECT_PRED2(says, errorOf({.load = "force \"3*$x\"; direction (0 -1 0); mass 100;"}), "$x is unknown here");
    EXPECT_PRED2(says, errorOf({.load = "force 1; direction (0 0 0); mass 100;"}), "the direction must not be (0 0 0)");
    EXPECT_PRED2(says, errorOf({.ofLid = "velocity (0 -1 0);"}), "by its velocity or by its load");
    EXPECT_PRED2(says, errorOf({.more = "integration { scheme implicit; }", .isSoil = false}), "cannot go by a load here");
}

}
