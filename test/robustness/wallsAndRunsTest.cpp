/// Walls that reflection cannot represent, runs that blow up, and disks that are full.
#include "SmallDisk.hpp"
#include "SmallFiles.hpp"
#include "refusal.hpp"
#include <csignal>
#include <fcntl.h>
#include <regex>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

namespace sph::test::wallsAndRunsTest
{
namespace
{

TEST(Walls, MoreCurvedThanTheSupport)
{
    Damaged c;
    c.replace("constant/geometry", "walls\n{", "walls\n{\n    rod { type cylinder; point (0.5 0.5 0); radius 0.1; fluid outside; }");
    c.isRefused("meshToGhost", {"constant/geometry:4", "rod"}, "-check");
}

// A plate thinner than the support made of two planes back to back: each side's fluid would be mirrored into the other side's.
TEST(Walls, ThinnerThanTheSupport)
{
    Damaged c;
    c.replace("constant/geometry", "walls\n{", "walls\n{\n    plate { type box; min (0 0.45 0); max (1 0.5 0); fluid outside; }");
    c.isRefused("meshToGhost", {"constant/geometry:4"}, "-check");
}

// OpenFOAM's patches have a type slip; here a type is a shape.
TEST(Walls, WithThePatchTypeSlipAreToldWhatToWrite)
{
    Damaged c;
    c.replace("constant/geometry", "walls\n{", "walls\n{\n    lid { type slip; }");
    c.isRefused("meshToGhost", {"constant/geometry:4", "\"slip\" is unknown", "`slip yes;`"}, "-check");
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
        EXPECT_TRUE(std::regex_search(
            outcome.err,
            std::regex("the density of water has reached -[0-9.]+ kg/m\\^3 in particle [0-9]+ at \\(0[^)]*\\) at time 0.05625,")))
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
    EXPECT_TRUE(std::regex_search(
        found[0], std::regex("Warning: at time 0.02 deltaT 0.002 s is 1.2[0-9] times the longest stable step, 0.0015[0-9]* s by sound")))
        << found[0];
}

// A dry run says how many steps the run will take, exactly where they are fixed, and how long that is; and leaves the case as it was.
TEST(Runs, DryOnesEstimateTheirSteps)
{
    Damaged c;
    c.replace("system/controlDict", "adjustTimeStep yes;", "adjustTimeStep no; deltaT 0.0005;");
    const auto before = c.files(".");
    const auto log = c.runWell("sphFoamLike", "-dry-run");
    EXPECT_TRUE(std::regex_search(
        log,
        std::regex(
            "Estimate  : [-+.0-9e]+ s of clock a step, 0.0005 s of the run, by the last 13 of 40 steps in memory, until 0.04 s; 40 steps to "
            "endTime 0.04 s: [-+.0-9e]+ s. Nothing was written\n$")))
        << log;
    EXPECT_EQ(difference(before, c.files(".")), "");
    c.replace("system/controlDict", "endTime 0.04", "endTime 10000.02");
    const auto longer = c.runWell("sphFoamLike", "-dry-run");
    EXPECT_TRUE(
        std::regex_search(longer,
                          std::regex("by the last [0-9]+ of [0-9]+ steps in memory, until [.0-9]+ s; 2e\\+07 steps to endTime "
                                     "10000 s: [.0-9]+ (s|minutes|hours), if steps stay as long and cost as much as these: a scene that "
                                     "fills, breaks up or speeds up later may take two or three times as long. Nothing")))
        << longer;
}

// A time from 10^5 s on whose 6 digits would be those of another one has a folder of its own name, from which the run goes on as if it had
// not been stopped: the last folders of both are the same to the last byte.
TEST(Runs, RestartAtLateTimes)
{
    const auto late = [](const std::string& end)
    {
        Files files = channelCase();
        auto& control = files["system/controlDict"];
        control.replace(control.find("startFrom latestTime; startTime 0"), 33, "startFrom latestTime; startTime 100000");
        control.replace(control.find("0.08"), 4, end);
        return files;
    };
    const TestCase whole(late("100000.04")), parts(late("100000.02"));
    for (const auto* c : {&whole, &parts})
    {
        c->runWell("packParticles");
        c->runWell("meshToGhost");
        std::filesystem::rename(c->folder() / "0", c->folder() / "100000");
        c->runWell("sphFoamLike");
    }
    ASSERT_TRUE(whole.has("100000.02") && whole.has("100000.04") && parts.has("100000.02"));
    EXPECT_EQ(difference(whole.files("100000.02"), parts.files("100000.02")), "");
    parts.replace("system/controlDict", "endTime 100000.02", "endTime 100000.04");
    parts.replace("system/controlDict", "startFrom latestTime; startTime 100000;", "startFrom startTime; startTime 100000.02;");
    parts.runWell("sphFoamLike");
    EXPECT_EQ(difference(whole.files("100000.04"), parts.files("100000.04")), "");
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

// A terminal that is closed ends a run as any other signal does: the present time is written, and the exit code is that of a shell for the signal, so that no script goes on as if all were done.
TEST(Runs, EndedBySignals)
{
    for (const auto& [signal, number] : {std::pair("HUP", SIGHUP), std::pair("TERM", SIGTERM), std::pair("INT", SIGINT)})
    {
        Damaged c;
        c.replace("system/controlDict", "endTime 0.04", "endTime 1e5");
        c.replace("system/controlDict", "writeInterval 0.02", "writeInterval 1e5");
        const auto command = std::string("OMP_NUM_THREADS=1 timeout --preserve-status -s ") + signal +
                             " 3 '" SPH_APPLICATIONS "/sphFoamLike' -case '" + c.folder().string() + "' > '" + c.folder().string() +
                             "/log' 2>&1 < /dev/null";
        EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 128 + number) << signal;
        EXPECT_NE(c.read("log").find("Stopped by signal " + std::to_string(number)), std::string::npos) << c.read("log");
        std::size_t times = 0;
        for (const auto& entry : std::filesystem::directory_iterator(c.folder()))
            times += std::filesystem::exists(entry.path() / "uniform/time");
        EXPECT_EQ(times, 2u) << signal << ": 0.02, and where it was stopped";
        EXPECT_FALSE(c.has(".lock"));
    }
}

// Two runs in one case would take one another's time folders away: the second one says who has the case. What a killed run has left is taken over.
TEST(Runs, TwoInOneCase)
{
    Damaged c;
    c.replace("system/controlDict", "endTime 0.04", "endTime 1e5");
    c.replace("system/controlDict", "writeInterval 0.02", "writeInterval 1e5");
    const auto first = fork();
    if (first == 0)
    {
        const int nowhere = open("/dev/null", O_RDWR);
        for (const int standard : {0, 1, 2}) dup2(nowhere, standard);
        execl(SPH_APPLICATIONS "/sphFoamLike", "sphFoamLike", "-case", c.folder().c_str(), nullptr);
        _exit(127);
    }
    const auto process = "sphFoamLike, process " + std::to_string(first);
    for (int tenths = 0; tenths < 100 && c.read(".lock").find(process) == std::string::npos; ++tenths) usleep(100'000);
    c.isRefused("sphFoamLike", {".lock: another program is at work in this case: " + process});
    c.isRefused("packParticles", {process});
    EXPECT_EQ(c.run("sphFoamLike", "-dry-run").code, 0);
    kill(first, SIGKILL);
    waitpid(first, nullptr, 0);
    EXPECT_TRUE(c.has(".lock"));
    c.replace("system/controlDict", "endTime 1e5", "endTime 0.04");
    c.replace("system/controlDict", "writeInterval 1e5", "writeInterval 0.02");
    c.runWell("sphFoamLike");
    EXPECT_FALSE(c.has(".lock"));
    c.replace("system/sphSchemes", "secondOrder", "nonsense");
    c.isRefused("sphFoamLike", {"nonsense"});
    EXPECT_FALSE(c.has(".lock"));
}

// A field that does not exist shows when the function object first runs, which may be at the end: the state of the end is written before the error ends the run, and sphPostProcess can go on with it.
TEST(Runs, WhoseFunctionObjectFailsAtTheEnd)
{
    const Damaged c;
    c.replace(
        "system/controlDict", "endTime 0.04",
        "functions { late { type reduction; executeControl onEnd; numbers { n { operation mean; value \"$nope\"; } } } }\nendTime 0.04");
    const auto outcome = c.run("sphFoamLike");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("nope"), std::string::npos) << outcome.err;
    EXPECT_TRUE(std::filesystem::exists(c.folder() / "0.04/lagrangian/sph/U"));
}

TEST(Runs, WithAnEndThatIsPast)
{
    Damaged c;
    for (const char* end : {"0.02", "0.01", "-1"})
    {
        c.replace("system/controlDict",
                  c.read("system/controlDict").find("endTime 0.04") != std::string::npos ? "endTime 0.04" : "endTime 0.01",
                  std::string("endTime ") + end);
        EXPECT_NE(c.runWell("sphFoamLike")
                      .find(std::string("--> Warning: nothing to do: the run starts at 0.02 s and endTime is ") + end + " s."),
                  std::string::npos);
        c.replace("system/controlDict", std::string("endTime ") + end, "endTime 0.01");
    }
}

// A phase that nothing holds has no density to report.
TEST(Runs, OfAPhaseWithoutParticles)
{
    Damaged c;
    c.replace("constant/phaseProperties", "phases (water);", "phases (water oil);\noil { rho 900; mu 10; soundSpeed 15; }");
    c.replace("system/sphSchemes", "secondOrder", "reflected");
    const auto log = c.runWell("sphFoamLike");
    EXPECT_NE(log.find("; oil: no particles"), std::string::npos) << log;
    EXPECT_EQ(log.find("inf"), std::string::npos) << log;
}

// A file that cannot be written whole leaves the former one: the particles of the start, the walls, a dictionary.
TEST(Disk, FullForEveryProgramThatWrites)
{
    Damaged c;
    c.write("system/sphSchemes", c.read("system/sphSchemes") + "// " + std::string(5000, '*') + "\n");
    const auto before = c.files(".");
    for (const auto& [application, arguments] :
         std::vector<std::pair<std::string, std::string>>{{"packParticles", ""},
                                                          {"packParticles", "-time 0.5"},
                                                          {"meshToGhost", ""},
                                                          {"sphFoamLike", ""},
                                                          {"sphDictionary", "system/sphSchemes -entry wallVelocity -set reflected"}})
    {
        SCOPED_TRACE(application + " " + arguments);
        {
            const SmallFiles limit(4096);
            c.isRefused(application, {"cannot be written: File too large"}, arguments);
        }
        auto after = c.files(".");
        after.erase(c.folder().filename().string() + ".foam"); // whole, for it is empty
        EXPECT_EQ(difference(before, after), "");
    }
}

// A disk of 128 kB holds the first time folder and not the second: exit code 1, the first one whole, nothing half-written under
// a time's name.
TEST(Disk, Full)
{
    const SmallDisk disk("128k");
    if (!disk.mounted()) GTEST_SKIP() << SmallDisk::notPermitted;
    {
        const TestCase c(Files{}, disk.folder());
        for (const char* part : {"system", "0.02", "constant/geometry", "constant/phaseProperties", "constant/g", "constant/walls"})
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
