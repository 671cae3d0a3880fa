/// Walls that reflection cannot represent, runs that blow up, and disks that are full.
#include "refusal.hpp"
#include <memory>
#include <regex>
#include <sstream>
#include <sys/mount.h>

namespace sph::test
{
namespace
{

TEST(Walls, MoreCurvedThanTheSupport)
{
    Damaged c;
    c.replace("constant/geometry", "walls\n{",
              "walls\n{\n    rod { type cylinder; point (0.5 0.5 0); radius 0.1; fluid outside; }");
    c.isRefused("meshToGhost", {"constant/geometry:4", "rod"}, "-check");
}

// A plate thinner than the support made of two planes back to back: each side's fluid would be mirrored into the other side's.
TEST(Walls, ThinnerThanTheSupport)
{
    Damaged c;
    c.replace("constant/geometry", "walls\n{", "walls\n{\n    plate { type box; min (0 0.45 0); max (1 0.5 0); fluid outside; }");
    c.isRefused("meshToGhost", {"constant/geometry:4"}, "-check");
}

TEST(Runs, BlownUpByAnAbsurdVelocity)
{
    Damaged c;
    for (const char* time : {"0", "0.02"}) std::filesystem::remove_all(c.folder() / time);
    c.replace("system/packParticlesDict", "U 1;", "U 1e7;");
    c.runWell("packParticles");
    c.isRefused("sphFoamLike", {"water has reached 9.8", "at time 0,", "times its sound speed"});
}

// A sound speed of a thousandth of the flow's lets particles pile up without bound, though every number stays finite:
// their speed tells before the density does.
TEST(Runs, WithASoundSpeedFarTooSmall)
{
    Damaged c;
    c.replace("constant/phaseProperties", "soundSpeed 15", "soundSpeed 1e-3");
    c.replace("constant/phaseProperties", "mu 10", "mu 0");
    c.replace("system/sphSchemes", "wallVelocity secondOrder;", "");
    c.replace("system/controlDict", "endTime 0.04", "endTime 2");
    c.replace("system/controlDict", "writeInterval 0.02", "writeInterval 2");
    c.isRefused("sphFoamLike", {"water has reached", "e+03 times its sound speed", "a larger sound speed"});
}

// A fixed step far beyond the limits: particles shoot through one another, and the run ends with an error that names the time.
TEST(Runs, WithAFixedStepFarTooLarge)
{
    Damaged c;
    c.replace("system/controlDict", "adjustTimeStep yes;", "adjustTimeStep no; deltaT 0.02;");
    c.replace("system/controlDict", "endTime 0.04", "endTime 40");
    c.replace("system/controlDict", "writeInterval 0.02", "writeInterval 40");
    c.isRefused("sphFoamLike", {"density of water has reached", " at time 0.0", "a smaller step"});
}

/// A column at rest under its own pressure, and one step of 75 times what sound allows, 0.00075 s.
Files columnInOneStep(const std::string& stopAt)
{
    auto files = columnCase();
    files["system/packParticlesDict"] = std::regex_replace(files["system/packParticlesDict"], std::regex("6000"), "9810");
    files["system/controlDict"] = "stopAt " + stopAt + "; endTime 0.05625; adjustTimeStep no; deltaT 0.05625; writeControl none;\n";
    return files;
}

// The last step alone makes the densities negative: it is looked at as all others are, whether a time folder is written at its end or not.
TEST(Runs, WithADensityBelowZeroAfterTheLastStep)
{
    for (const char* stopAt : {"endTime", "noWriteNow"})
    {
        const TestCase c(columnInOneStep(stopAt));
        c.runWell("packParticles");
        c.runWell("meshToGhost");
        const auto outcome = c.run("sphFoamLike");
        EXPECT_EQ(outcome.code, 1) << stopAt << outcome.out;
        EXPECT_TRUE(std::regex_search(outcome.err, std::regex("the density of water has reached -[0-9.]+ kg/m\\^3 in particle [0-9]+ at \\(0[^)]*\\) at time 0.05625,")))
            << outcome.err;
        EXPECT_FALSE(c.has("0.05625"));
    }
}

// Told once, at the first step, with the step and its limit; a step of the limit itself is none beyond it.
TEST(Runs, WithAFixedStepBeyondTheLimit)
{
    const auto warnings = [](const std::string& deltaT)
    {
        Damaged c;
        c.replace("system/controlDict", "adjustTimeStep yes;", "adjustTimeStep no; deltaT " + deltaT + ";");
        std::vector<std::string> found;
        std::istringstream log(c.runWell("sphFoamLike"));
        for (std::string line; std::getline(log, line);)
            if (line.find("longest stable step") != std::string::npos) found.push_back(line);
        return found;
    };
    EXPECT_EQ(warnings("0.0012").size(), 0u);
    const auto found = warnings("0.002");
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(std::regex_search(found[0], std::regex("Warning: at time 0.02 deltaT 0.002 s is 1.2[0-9] times the longest stable step, 0.0015[0-9]* s by sound")))
        << found[0];
}

// A shear flow compresses nothing: rows that slide ever faster are known by their speed alone.
TEST(Runs, WithViscosityUnstableInAShearFlow)
{
    Damaged c;
    c.replace("constant/phaseProperties", "mu 10", "mu 1e5");
    c.replace("system/sphSchemes", "scheme predictorCorrector;", "scheme leapfrog; stepFactor 4;");
    c.isRefused("sphFoamLike", {"water has reached", "times its sound speed", "limited by viscosity"});
}

// Particles at rest that nothing moves: a run of no events ends well, at its end time.
TEST(Runs, OfNothingAtAll)
{
    Damaged c;
    for (const char* time : {"0", "0.02"}) std::filesystem::remove_all(c.folder() / time);
    c.write("system/packParticlesDict", "lattice cubic;\n");
    c.replace("constant/g", "(1 0 0)", "(0 0 0)");
    c.runWell("packParticles");
    c.runWell("sphFoamLike");
    EXPECT_TRUE(c.has("0.04/lagrangian/sph/U"));
}

// A disk of 128 kB holds the first time folder and not the second: exit code 1, the first one whole, nothing half-written under
// a time's name.
TEST(Disk, Full)
{
    const TestCase place(Files{});
    if (::mount("tmpfs", place.folder().c_str(), "tmpfs", 0, "size=128k") != 0)
        GTEST_SKIP() << "a small disk is made by mounting a tmpfs, which this machine does not permit";
    const auto unmount = [](const TestCase* p) { ::umount2(p->folder().c_str(), MNT_DETACH); };
    const std::unique_ptr<const TestCase, decltype(unmount)> mounted(&place, unmount);
    {
        const TestCase c(Files{}, place.folder());
        for (const char* part :
             {"system", "0.02", "constant/geometry", "constant/phaseProperties", "constant/g", "constant/walls"})
        {
            std::filesystem::create_directories((c.folder() / part).parent_path());
            c.copyFrom(goodChannel(), part);
        }
        c.replace("system/controlDict", "endTime 0.04", "endTime 0.4");
        const auto before = c.files("0.02");
        const auto outcome = c.run("sphFoamLike");
        EXPECT_EQ(outcome.code, 1) << outcome.out;
        EXPECT_NE(outcome.err.find("No space left on device"), std::string::npos) << outcome.err;
        EXPECT_EQ(difference(before, c.files("0.02")), "");
        for (const auto& entry : std::filesystem::directory_iterator(c.folder()))
        {
            const auto name = entry.path().filename().string();
            EXPECT_TRUE(name[0] != '0' || name.find(".partial") != std::string::npos || c.has(name + "/uniform/time"))
                << name << " is not whole";
        }
    }
}

}
}
