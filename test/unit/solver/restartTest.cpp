/// A run that was stopped and started again ends with the same bytes as one that was not; so does a run on two threads.
#include "Largest.hpp"
#include "smallCases.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <regex>
#include <sstream>

namespace sph::test::restartTest
{
namespace
{

void prepare(const TestCase& c)
{
    c.runWell("packParticles");
    c.runWell("meshToGhost");
}

/// Compares the last time folder, byte for byte: positions, fields, and the numbers of the state (time, index, step, density
/// scale).
void restartEqualsTheWhole(const Files& files, const std::string& end = "0.08", const std::string& half = "0.04", int rebuilds = 6)
{
    const TestCase whole(files), parts(files);
    prepare(whole);
    for (const char* made : {"0", "constant/walls", "constant/lagrangian"})
        if (whole.has(made)) parts.copyFrom(whole, made);
    const auto log = whole.runWell("sphFoamLike");

    // The particles compared must have moved: lists rebuilt between write times, not only at them.
    const auto built = log.rfind("lists built ");
    ASSERT_NE(built, std::string::npos);
    EXPECT_GT(std::stoi(log.substr(built + 12)), rebuilds) << "the case is too quiet to show anything";

    parts.replace("system/controlDict", "endTime " + end, "endTime " + half);
    parts.runWell("sphFoamLike");
    ASSERT_TRUE(parts.has(half + "/uniform/time"));
    ASSERT_FALSE(parts.has(end));
    parts.replace("system/controlDict", "endTime " + half, "endTime " + end);
    parts.runWell("sphFoamLike");
    EXPECT_EQ(difference(whole.files(end), parts.files(end)), "");
}

Files with(Files files, const std::string& integrator, const std::string& inPlaceOf = "predictorCorrector")
{
    auto& schemes = files["system/sphSchemes"];
    schemes.replace(schemes.find(inPlaceOf), inPlaceOf.size(), integrator);
    return files;
}

TEST(Restart, OfPredictorCorrectorWithSecondOrderWalls) { restartEqualsTheWhole(channelCase()); }
TEST(Restart, OfLeapfrogWithSecondOrderWalls) { restartEqualsTheWhole(with(channelCase(), "leapfrog")); }
TEST(Restart, OfSymplecticEulerWithSecondOrderWalls) { restartEqualsTheWhole(with(channelCase(), "symplecticEuler")); }
TEST(Restart, OfSemiImplicitWithSecondOrderWalls) { restartEqualsTheWhole(with(channelCase(), "semiImplicit")); }
TEST(Restart, OfTwoPhasesWithSemiImplicit) { restartEqualsTheWhole(with(dropCase(), "semiImplicit")); }
TEST(Restart, OfTwoPhasesWithImplicit) { restartEqualsTheWhole(with(dropCase(), "implicit")); }
TEST(Restart, OfGasInABand)
{
    auto files = with(dropCase(), "implicit");
    files["system/sphSchemes"] += "gas band; gasBand 2.5;\n";
    restartEqualsTheWhole(files);
}
TEST(Restart, OfTwoPhasesWithSurfaceTension) { restartEqualsTheWhole(dropCase()); }
TEST(Restart, OfTwoPhasesWithShifting)
{
    for (const char* integrator : {"predictorCorrector", "implicit"})
    {
        SCOPED_TRACE(integrator);
        auto files = with(dropCase(), integrator);
        files["system/sphSchemes"] += "shifting 2;\n";
        restartEqualsTheWhole(files);
    }
}
TEST(Restart, OfTwoPhasesWithLeapfrog) { restartEqualsTheWhole(with(dropCase(), "leapfrog")); }
TEST(Restart, OfIntegratedDensityAndShiftingAtACurvedWall) { restartEqualsTheWhole(grainCase()); }
TEST(Restart, OfIntegratedDensityWithLeapfrog) { restartEqualsTheWhole(with(grainCase(), "leapfrog")); }
TEST(Restart, OfSurfaceTensionOnceInAStepOfParts)
{
    for (const char* integrator : {"predictorCorrector; maxSubSteps 3", "leapfrog; maxSubSteps 3", "symplecticEuler; maxSubSteps 5"})
    {
        SCOPED_TRACE(integrator);
        restartEqualsTheWhole(with(dropCase(), integrator));
    }
    auto stress = with(dropCase(), "leapfrog; maxSubSteps 3");
    stress["system/sphSchemes"] += "surfaceTension interfaceStress;\n";
    restartEqualsTheWhole(stress);
}
// The history of function objects is in the folder that is compared: a fit over the whole run, the first sums, a count of write times.
TEST(Restart, OfWhatFunctionObjectsHaveSeen)
{
    auto files = dropCase();
    files["system/controlDict"] +=
        "libs (\"libsphVerification.so\");\nfunctions\n{\n"
        "    drift { type conservation; executeInterval 2; }\n"
        "    period { type errors; executeControl timeStep; executeInterval 3; reference { type formula; name dropPeriod; radius 0.4; } }\n}\n";
    restartEqualsTheWhole(files);
}
TEST(Restart, OfATransportVelocity)
{
    for (const char* integrator : {"predictorCorrector", "leapfrog", "symplecticEuler"})
    {
        SCOPED_TRACE(integrator);
        auto files = with(channelCase(), integrator);
        files["system/sphSchemes"] += "transportVelocity 1;\n";
        restartEqualsTheWhole(files);
    }
}
TEST(Restart, OfNaturalConvection)
{
    for (const char* integrator : {"predictorCorrector", "leapfrog", "symplecticEuler", "semiImplicit", "implicit", "verlet"})
    {
        SCOPED_TRACE(integrator);
        restartEqualsTheWhole(with(convectionCase(), integrator));
    }
}
TEST(Restart, OfAFallingColumnWithAFreeSurface) { restartEqualsTheWhole(columnCase()); }
TEST(Restart, OfAColumnInAShakenVessel)
{
    auto files = columnCase();
    files["constant/g"] = "dimensions [0 1 -2 0 0 0 0]; value (0 -9.81 0); shaking \"vector(20*sin(60*$t), 0, 0)\";\n";
    restartEqualsTheWhole(files);
}
TEST(Restart, OfASuspension) { restartEqualsTheWhole(suspensionCase()); }
TEST(Restart, OfASuspensionInCreepingFlow) // its particles stay where they are
{
    auto files = with(suspensionCase(), "quasiSteady", "semiImplicit");
    files = with(files, "shifting 0", "shifting 2");
    files["system/packParticlesDict"] = "lattice cubic; jitter 0.001;\nfill ( { region all; phase feedstock; } );\n";
    restartEqualsTheWhole(files, "0.08", "0.04", 2);
}
// Increments and the older stress are state, and so are the steps since the levels were re-coupled.
TEST(Restart, OfVerlet)
{
    auto diffusing = with(channelCase(), "verlet"), grain = with(grainCase(), "verlet; verletSteps 7");
    diffusing["constant/scalarTransport"] = "dye { D 0.01; initial \"$y\"; }\n";
    grain["system/sphSchemes"] += "wallVelocity reflected;\n";
    for (const auto& files : {diffusing, grain, with(dropCase(), "verlet"), with(columnCase(), "verlet", "leapfrog")})
        restartEqualsTheWhole(files);
}
TEST(Restart, OfSoil)
{
    restartEqualsTheWhole(soilCase());
    auto withFriction = soilCase();
    auto& geometry = withFriction["constant/geometry"];
    for (int wall = 0; wall < 2; ++wall) geometry.replace(geometry.find("slip yes;"), 9, "frictionAngle 20;");
    restartEqualsTheWhole(withFriction);
    auto pressed = soilCase();
    auto& press = pressed["constant/geometry"];
    press.replace(press.find("normal (-1 0 0); slip yes;"), 26, "normal (-1 0 0); velocity (-0.2 0 0); slip yes;");
    restartEqualsTheWhole(pressed);
    restartEqualsTheWhole(loadedSoilCase());
    auto byVerlet = soilCase();
    byVerlet["system/sphSchemes"] += "integration { scheme verlet; damping { rate 20; until 0.06; } }\n";
    restartEqualsTheWhole(byVerlet);
    auto byLeapfrog = soilCase();
    byLeapfrog["system/sphSchemes"] += "density continuity; integration { scheme leapfrog; }\n";
    restartEqualsTheWhole(byLeapfrog);
}
TEST(Restart, OfASuspensionAsPrinted)
{
    for (const char* integrator : {"predictorCorrector", "leapfrog", "quasiSteady"})
    {
        SCOPED_TRACE(integrator);
        auto files = suspensionCase();
        files["system/sphSchemes"] =
            "scheme paperPowder;\nresolution { spacing 0.05; }\nintegration { scheme " + std::string(integrator) + "; }\n";
        files["system/packParticlesDict"] = "lattice cubic; jitter 0.001;\nfill ( { region all; phase feedstock; } );\n";
        restartEqualsTheWhole(files, "0.08", "0.04", 2);
    }
}
TEST(Restart, OfWallsByLayers)
{
    auto channel = channelCase(), grain = grainCase(), powder = suspensionCase(), open = openCase();
    for (auto* files : {&channel, &grain, &powder, &open})
    {
        (*files)["system/sphSchemes"] += "walls layers;\n";
        restartEqualsTheWhole(*files);
    }
}
TEST(Restart, OfASceneWithAnInletAndAnOutlet) { restartEqualsTheWhole(openCase()); }
// The energy of particles that pass a plane as a time folder is written counts with the step behind it.
TEST(Restart, OfTheEnergyThatPassesOpenings)
{
    auto files = openCase();
    auto& control = files["system/controlDict"];
    control.replace(control.find("0.02"), 4, "0.01");
    control += "functions { sums { type conservation; } }\n";
    for (const char* half : {"0.05", "0.06"}) // without its number a particle's energy is lost at either
    {
        SCOPED_TRACE(half);
        restartEqualsTheWhole(files, "0.08", half);
    }
}
TEST(Restart, OfABedInThreeDimensions) { restartEqualsTheWhole(bedCase(), "0.04", "0.02"); }

/// The numbers of a table, without the rows of time 0 in one with times.
std::vector<double> numbersOf(const std::string& table, bool ofTimes)
{
    std::istringstream in(table);
    std::vector<double> all;
    for (std::string line; std::getline(in, line);)
    {
        if (line.starts_with("#") || (ofTimes && line.starts_with("0\t"))) continue;
        std::replace_if(
            line.begin(), line.end(), [](char c) { return c == '(' || c == ')'; }, ' ');
        std::istringstream cells(line);
        for (double q; cells >> q;) all.push_back(q);
    }
    return all;
}
void expectSameNumbers(const std::string& found, const std::string& expected, bool ofTimes, const std::string& name)
{
    const auto a = numbersOf(found, ofTimes), b = numbersOf(expected, ofTimes);
    ASSERT_EQ(a.size(), b.size()) << name;
    ASSERT_FALSE(b.empty()) << name;
    Largest largest;
    for (const double q : b) largest(q);
    for (std::size_t k = 0; k < b.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-14 * largest.value()) << name;
}

// What sphPostProcess makes of a stored time is what the run made of it, but for the round-off of V = m/rho, also where the volume is not that.
TEST(StoredTimes, GiveTheTablesOfTheRun)
{
    auto continuity = grainCase();
    continuity["system/sphSchemes"] += "volume numberDensity;\n";
    for (auto files : {dropCase(), continuity})
    {
        files["system/controlDict"] +=
            "functions\n{\n"
            "    sums { type conservation; angularMomentum yes; }\n"
            "    mean { type volFieldValue; operation volAverage; fields (p rho); min (0.1 0.2 0); max (0.9 0.8 0); }\n"
            "    bins { type profile; start (0 0 0); end (0 1 0); bins 10; fields (p U); }\n"
            "    line { type profile; start (0.1 0.1 0); end (0.9 0.9 0); nPoints 7; fields (p U); }\n}\n";
        const TestCase c(files);
        prepare(c);
        c.runWell("sphFoamLike");
        std::filesystem::rename(c.folder() / "postProcessing", c.folder() / "ofTheRun");
        c.runWell("sphPostProcess", "-time 0.02:");
        const auto run = c.files("ofTheRun"), stored = c.files("postProcessing");
        for (const std::string table : {"sums/*/conservation.dat", "mean/*/volFieldValue.dat"})
        {
            const auto at = [&](const std::string& time) { return std::string(table).replace(table.find('*'), 1, time); };
            expectSameNumbers(stored.at(at("0.02")), run.at(at("0")), true, table);
        }
        int profiles = 0;
        for (const auto& [name, text] : stored)
            if (name.ends_with(".xy"))
            {
                ++profiles;
                expectSameNumbers(text, run.at(name), false, name);
            }
        EXPECT_EQ(profiles, 2 * 4);
    }
}

// Written as text a time folder loses nothing either: the shortest decimals read back to the same numbers.
TEST(Restart, FromTextFiles)
{
    auto files = channelCase();
    auto& control = files["system/controlDict"];
    control.replace(control.find("binary"), 6, "ascii");
    restartEqualsTheWhole(files);
}

/// The solver takes a thread for each 2000 particles: 8000 and more on one, two and four threads, which share two processors. All that a run writes is the
/// same to the byte, tables of function objects included, and so is what sphPostProcess makes of it; but for the time it took.
void threadsDoNotChangeABit(Files files, const std::string& spacing = "0.011")
{
    auto& schemes = files["system/sphSchemes"];
    schemes = std::regex_replace(schemes, std::regex("spacing [0-9.]+"), "spacing " + spacing);
    auto& control = files["system/controlDict"];
    control = std::regex_replace(std::regex_replace(control, std::regex("endTime 0[0-9.]+"), "endTime 0.004"),
                                 std::regex("writeInterval [0-9.]+"), "writeInterval 0.002");
    control +=
        "functions { sums { type conservation; executeInterval 3; } bins { type profile; start (0 0 0); end (0 1 0); bins 10; fields (p U); } }\n";
    std::map<int, Files> made;
    std::unique_ptr<const TestCase> first;
    for (const int threads : {1, 2, 4})
    {
        auto c = std::make_unique<const TestCase>(files);
        if (!first) prepare(*c);
        for (const char* part : {"0", "constant/walls", "constant/lagrangian"})
            if (first && first->has(part)) c->copyFrom(*first, part);
        const auto log = c->runWell("sphFoamLike", "", threads);
        EXPECT_NE(log.find(fmt::format("Threads: {}\n", threads)), std::string::npos);
        c->runWell("sphPostProcess", "-time 0.002:", threads);
        for (const char* folder : {"0.002", "0.004", "postProcessing"})
            for (const auto& [name, text] : c->files(folder)) made[threads][std::string(folder) + "/" + name] = text;
        EXPECT_GT(made[threads].size(), 8u);
        if (!first) first = std::move(c);
    }
    EXPECT_EQ(difference(made[1], made[2]), "");
    EXPECT_EQ(difference(made[1], made[4]), "");
}
TEST(Threads, DoNotChangeABit) { threadsDoNotChangeABit(dropCase()); }
TEST(Threads, DoNotChangeABitOfWallsByLayers)
{
    auto files = channelCase();
    files["system/sphSchemes"] += "walls layers;\n";
    threadsDoNotChangeABit(files);
}
// What comes in and goes is put in order and counted; powder migrates, and the viscosity is solved for.
TEST(Threads, DoNotChangeABitOfOpeningsAndMigration) { threadsDoNotChangeABit(openCase()); }
TEST(Threads, DoNotChangeABitOfSoil) { threadsDoNotChangeABit(soilCase()); }
TEST(Threads, DoNotChangeABitOfMigrationAlone)
{
    auto files = suspensionCase();
    files["system/packParticlesDict"] = "lattice cubic;\n";
    files["system/sphSchemes"] = "resolution { spacing 0.05; support 2.6; kernel quinticSpline; }\nintegration { scheme quasiSteady; }\n";
    files["system/controlDict"] += "maxDeltaT 0.001;\n";
    threadsDoNotChangeABit(files);
    files["system/sphSchemes"] += "integration { migration semiImplicit; }\n";
    threadsDoNotChangeABit(files);
}
// Conjugate gradients for pressure and viscosity, with surface tension and shifting.
TEST(Threads, DoNotChangeABitOfAnImplicitStep)
{
    auto files = dropCase();
    files["system/sphSchemes"] =
        "resolution { spacing 0.05; support 3; kernel wendlandC2; }\nshifting 2;\nintegration { scheme implicit; }\n";
    threadsDoNotChangeABit(files);
}
TEST(Threads, DoNotChangeABitInThreeDimensionsWithWalls) { threadsDoNotChangeABit(bedCase(), "0.042"); }

// Layers are made where they are asked for, and nowhere else; a run that lacks them says who makes them.
TEST(WallLayers, AreMadeByMeshToGhostAndAskedForByTheRun)
{
    const TestCase c(channelCase());
    prepare(c);
    EXPECT_FALSE(c.has("constant/lagrangian"));
    const auto schemes = c.read("system/sphSchemes");
    c.write("system/sphSchemes", schemes + "walls layers;\n");
    const auto refused = c.run("sphFoamLike");
    EXPECT_NE(refused.code, 0);
    EXPECT_NE(refused.err.find("constant/lagrangian/wallLayers: is missing, and `walls layers;` is in system/sphSchemes: run meshToGhost"),
              std::string::npos)
        << refused.err;
    EXPECT_NE(c.runWell("meshToGhost").find("constant/lagrangian/wallLayers: 120 particles"), std::string::npos);
    EXPECT_NE(c.runWell("sphFoamLike", "-dry-run").find("walls of 120 particles in layers"), std::string::npos);
    c.write("system/sphSchemes", schemes);
    c.runWell("meshToGhost");
    EXPECT_FALSE(c.has("constant/lagrangian"));
}

}
}
