/// Sweeps with mistakes in what they are told, that are interrupted and go on, and whose runs fail.
#include "smallCases.hpp"
#include <gtest/gtest.h>
#include <sstream>

namespace sph::test::workPrecisionTest
{
namespace
{

/// The channel of smallCases with an error to measure: two resolutions of a few dozen particles.
Files sweepCase()
{
    auto files = channelCase();
    files["system/controlDict"] +=
        "libs (\"libsphVerification.so\");\nfunctions\n{\n    errors\n    {\n        type errors; field U; component x;\n        reference { type formula; name "
        "planePoiseuille; nu 0.01; acceleration 1; width 1; }\n    }\n}\n";
    files["system/workPrecisionDict"] =
        "resolutions (6 8);\nsetResolution { \"system/sphSchemes\" { resolution { spacing #eval \"1.0/$n\"; } } }\n"
        "variants\n{\n    base { }\n}\nsteps (packParticles meshToGhost sphFoamLike);\n"
        "errors ( { field U.x; norm L2; } );\nplots no;\n";
    return files;
}

constexpr const char* table = "postProcessing/workPrecision/results.csv";
constexpr const char* dict = "system/workPrecisionDict";

void expectWords(const std::string& text, const std::vector<std::string>& words)
{
    for (const auto& word : words) EXPECT_NE(text.find(word), std::string::npos) << "no \"" << word << "\" in:\n" << text;
}

/// Rows of the table by "variant,resolution".
Files rowsOf(const TestCase& c)
{
    Files rows;
    std::istringstream in(c.read(table));
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) rows[line.substr(0, line.find(',', line.find(',') + 1))] = line;
    return rows;
}

/// Adds a step that does something once, in the run at 8, and nothing when it is run again.
void addStep(const TestCase& c, const std::string& what)
{
    const auto script = c.folder() / "step";
    c.write("step", "#!/bin/sh\ncase $PWD in */8) ;; *) exit 0 ;; esac\nif [ ! -e '" + c.folder().string() + "/once' ]; then touch '" +
                        c.folder().string() + "/once'; " + what + "; fi\n");
    std::filesystem::permissions(script, std::filesystem::perms::owner_all);
    c.replace(dict, "meshToGhost sphFoamLike", "meshToGhost sphFoamLike \"" + script.string() + "\"");
}

TEST(WorkPrecision, MistakesAreNamedTogetherBeforeTheFirstRun)
{
    const TestCase c(sweepCase());
    c.write(dict, "resolutions (8 -4 0);\n"
                  "setResolution { \"system/sphSchemes\" { resolution { spacing #eval \"1.0/$n\"; } } }\n"
                  "variants\n{\n"
                  "    unknownFile { \"system/sphScheme\" { density continuity; } }\n"
                  "    unknownEntry { \"system/sphSchemes\" { densty continuity; } }\n"
                  "    unknownBelow { \"system/sphSchemes\" { integration { schem leapfrog; } } }\n"
                  "    unknownValue { \"system/sphSchemes\" { resolution { kernel wendlandC9; } } }\n"
                  "    unknownFunction { \"system/controlDict\" { endTim 2; } }\n"
                  "}\n"
                  "steps (packParticles meshToGhosts sphFoamLike);\n"
                  "errors\n(\n    { field U.z; }\n    { field U.x; norm L3; }\n    { function error; field U.x; norm L1; }\n"
                  "    { field U.x; norm Linf; time 3; }\n);\n"
                  "peers (\"peer.csv\" \"missing.csv\");\ntimeLimits 3;\n");
    c.write("peer.csv", "variant,spacing,cpuSeconds,field,norm,error\nother,0.1,1,U.x,L2,1e\nother,0.1,1,U.x,L2\n");
    const auto outcome = c.run("workPrecision");
    EXPECT_EQ(outcome.code, 1);
    expectWords(outcome.err,
                {"--> FATAL ERROR", "workPrecisionDict:1: resolution -4 must be greater than 0",
                 "workPrecisionDict:1: resolution 0 must be",
                 "workPrecisionDict:5: the case has no file \"system/sphScheme\". Did you mean \"system/sphSchemes\"?",
                 "workPrecisionDict:6: system/sphSchemes: entry \"densty\" is not used here. Did you mean \"density\"?",
                 "workPrecisionDict:7: system/sphSchemes: entry \"schem\" is not used here", "workPrecisionDict:8: system/sphSchemes: ",
                 "wendlandC9", "workPrecisionDict:9: system/controlDict: entry \"endTim\" is not used here. Did you mean \"endTime\"?",
                 "workPrecisionDict:11: there is no application \"meshToGhosts\". Did you mean \"meshToGhost\"?",
                 "workPrecisionDict:14: function object errors compares no field \"U.z\"", "workPrecisionDict:15: ", "\"L3\"",
                 "workPrecisionDict:16: system/controlDict has no function object \"error\"",
                 "workPrecisionDict:17: time 3 is after the end of the run", "peer.csv:2: \"1e\" in column error is not a number",
                 "peer.csv:3: 5 cells under 6 columns", "missing.csv: cannot be read",
                 "workPrecisionDict:20: entry \"timeLimits\" is not used here. Did you mean \"timeLimit\"?"});
    EXPECT_FALSE(c.has("run"));
    EXPECT_FALSE(c.has("postProcessing"));
}

// The mistakes of the case itself are reported as such, once, not as those of each variant.
TEST(WorkPrecision, MistakesOfTheCaseKeepTheirPlace)
{
    const TestCase c(sweepCase());
    c.replace("system/sphSchemes", "wallVelocity secondOrder;", "wallVelocty secondOrder;");
    const auto outcome = c.run("workPrecision");
    EXPECT_EQ(outcome.code, 1);
    expectWords(outcome.err, {"--> FATAL ERROR\nsystem/sphSchemes:2: entry \"wallVelocty\" is not used here"});
    EXPECT_EQ(outcome.err.find("with variant"), std::string::npos) << outcome.err;
}

// A wall of triangles is known once meshToGhost has prepared it, in the check of the runs as in each of them; what it cannot prepare is a mistake of the variant.
TEST(WorkPrecision, SweepsOverMeshes)
{
    auto files = sweepCase();
    files["constant/geometry"] = "dimension 3; domain { min (0 0 0); max (1 1 1); periodic (x y z); }\nwalls { }\n";
    // A box through the domain in z, cut by its faces, and one that has lost a side.
    const std::string points = "OFF\n8 8 0\n0.3 0.3 0\n0.7 0.3 0\n0.7 0.7 0\n0.3 0.7 0\n0.3 0.3 1\n0.7 0.3 1\n0.7 0.7 1\n0.3 0.7 1\n",
                      sides = "3 0 1 5\n3 0 5 4\n3 1 2 6\n3 1 6 5\n3 2 3 7\n3 2 7 6\n";
    files["constant/triSurface/bar.off"] = points + sides + "3 3 0 4\n3 3 4 7\n";
    files["constant/triSurface/open.off"] = points + sides + "3 3 0 4\n3 3 0 4\n";
    const TestCase c(files);
    c.replace(dict, "base { }", "mesh { \"constant/geometry\" { walls { bar { type triSurface; file \"bar.off\"; fluid outside; } } } }");
    c.replace(dict, "packParticles meshToGhost", "meshToGhost packParticles");
    const auto well = c.run("workPrecision");
    EXPECT_EQ(well.code, 0) << well.out;
    const auto rows = rowsOf(c);
    EXPECT_EQ(rows.size(), 2u);
    for (const auto& [_, row] : rows) EXPECT_NE(row.find(",ok,"), std::string::npos) << row;

    c.replace(dict, "bar.off", "open.off");
    const auto outcome = c.run("workPrecision");
    EXPECT_EQ(outcome.code, 1);
    expectWords(outcome.err, {"workPrecisionDict:5: ", "open.off: ",
                              "but not the lines between them: that from (0.3 0.3 0) to (0.3 0.7 0) is there in one of them alone"});
}

// 3 x 0.1 is not 0.3, but that is what was asked for, and how the plan of the sweep shows it.
TEST(WorkPrecision, ShowsNumbersAsTheyAreWritten)
{
    const TestCase c(sweepCase());
    c.replace(dict, "base { }", "base { \"system/sphSchemes\" { integration { soundFactor #eval \"3*0.1\"; } } }");
    const auto log = c.runWell("workPrecision");
    EXPECT_NE(log.find("integration.soundFactor 0.3\n"), std::string::npos) << log;
}

TEST(WorkPrecision, NeedsItsDictionary)
{
    const TestCase c(channelCase());
    const auto outcome = c.run("workPrecision");
    EXPECT_EQ(outcome.code, 1);
    expectWords(outcome.err, {"system/workPrecisionDict: there is no such file"});
    EXPECT_EQ(c.run("workPrecision", "-help").code, 0);
}

// No word of the dictionary reaches a shell.
TEST(WorkPrecision, RunsNoShell)
{
    const TestCase c(sweepCase());
    c.replace(dict, "sphFoamLike)", "\"sphFoamLike; touch made\" \"$(touch made)\")");
    c.replace(dict, "base { }", "\"a;touch made\" { }");
    const auto outcome = c.run("workPrecision");
    EXPECT_EQ(outcome.code, 1);
    expectWords(outcome.err,
                {"there is no application \"sphFoamLike;\"", "there is no application \"$(touch\"", "needs a name of letters"});
    EXPECT_FALSE(c.has("made"));
}

TEST(WorkPrecision, DryRunWritesNothing)
{
    const TestCase c(sweepCase());
    const auto before = c.files("");
    const auto outcome = c.run("workPrecision", "-dry-run");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    expectWords(outcome.out, {"base/6", "base/8", "to run", "system/sphSchemes:resolution.spacing 0.125"});
    EXPECT_EQ(difference(before, c.files("")), "");
    EXPECT_FALSE(c.has("run"));
}

// A part of the ladder is run by itself; the table of what has been run goes to standard output with the peers' rows behind it, and nothing else does.
TEST(WorkPrecision, RunsAPartAndPrintsItsTable)
{
    const TestCase c(sweepCase());
    c.replace(dict, "base { }", "base { }\n    leapfrog { \"system/sphSchemes\" { integration { scheme leapfrog; } } }");
    c.replace(dict, "plots no;", "plots no;\npeers (\"peer.csv\");");
    c.write("peer.csv", "variant,spacing,cpuSeconds,field,norm,error\nother,0.1,1,U.x,L2,0.25\n");
    expectWords(c.run("workPrecision", "-csv").err, {"postProcessing/workPrecision/results.csv is not there: run workPrecision first"});
    expectWords(c.run("workPrecision", "-variants base,leapfrg").err, {"-variants: \"leapfrg\" is unknown. Did you mean \"leapfrog\"?"});
    EXPECT_EQ(c.run("workPrecision", "-coarsest 0").code, 1);
    EXPECT_FALSE(c.has("run"));

    c.runWell("workPrecision", "-coarsest 1 -variants leapfrog");
    EXPECT_EQ(c.runWell("workPrecision", "-csv"), c.read(table) + "other,,0.1,,,1,,,,U.x,L2,0.25,,ok,\n");
    const auto rows = rowsOf(c);
    EXPECT_EQ(rows.size(), 1u);
    EXPECT_TRUE(rows.contains("leapfrog,6"));
}

TEST(WorkPrecision, SaysBeforeTheFirstRunThatGnuplotIsMissing)
{
    const TestCase c(sweepCase());
    c.replace(dict, "plots no;", "");
    const std::string path = std::getenv("PATH");
    std::filesystem::create_directory(c.folder() / "bin");
    for (const std::string folder : {"/usr/bin", "/bin"})
        if (std::filesystem::exists(folder + "/timeout") && !c.has("bin/timeout"))
            std::filesystem::create_symlink(folder + "/timeout", c.folder() / "bin/timeout");
    ::setenv("PATH", (c.folder() / "bin").c_str(), 1);
    const auto outcome = c.run("workPrecision");
    ::setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(outcome.code, 1) << outcome.err;
    expectWords(outcome.err, {"the plots need gnuplot, which is not installed"});
    EXPECT_FALSE(c.has("run"));
}

// Stopped by TERM in the second run, it ends with an error, keeps the first row and leaves no process; started again it runs the second
// alone, and started a third time nothing. A byte of the case changed, everything is run again and the old rows are kept beside.
TEST(WorkPrecision, GoesOnWhereItWasInterrupted)
{
    const TestCase c(sweepCase());
    addStep(c, "kill -TERM $PPID; echo $$ > \"$PWD/../../../../pid\"; sleep 60");
    const auto first = c.run("workPrecision", "", 1, 60);
    EXPECT_EQ(first.code, 1) << first.out;
    expectWords(first.err, {"interrupted in base/8", "run workPrecision again to go on"});
    EXPECT_FALSE(std::filesystem::exists("/proc/" + std::to_string(std::atoi(c.read("pid").c_str()))));
    const auto rows = rowsOf(c);
    ASSERT_EQ(rows.size(), 1u);
    expectWords(rows.at("base,6"), {",U.x,L2,", ",ok,"});

    const auto second = c.run("workPrecision", "", 1, 60);
    EXPECT_EQ(second.code, 0) << second.err;
    expectWords(second.out, {"1 of them done already", "[2/2] base/8"});
    EXPECT_EQ(second.out.find("[1/2]"), std::string::npos);
    const auto whole = rowsOf(c);
    ASSERT_EQ(whole.size(), 2u);
    EXPECT_EQ(whole.at("base,6"), rows.at("base,6"));

    const auto third = c.run("workPrecision");
    EXPECT_EQ(third.code, 0) << third.err;
    expectWords(third.out, {"2 of them done already"});
    EXPECT_EQ(difference(rowsOf(c), whole), "");
    EXPECT_FALSE(c.has("postProcessing/workPrecision/results.old.csv"));

    c.replace("constant/g", "(1 0 0)", "(1.5 0 0)");
    const auto fourth = c.run("workPrecision", "", 1, 60);
    EXPECT_EQ(fourth.code, 0) << fourth.err;
    expectWords(fourth.out, {"0 of them done already", "[1/2] base/6"});
    EXPECT_NE(rowsOf(c).at("base,6"), whole.at("base,6"));
    EXPECT_NE(c.read("postProcessing/workPrecision/results.old.csv").find(whole.at("base,6")), std::string::npos);
}

// Killed without warning, it has the rows of the runs that had ended, and goes on behind them.
TEST(WorkPrecision, GoesOnAfterAKill)
{
    const TestCase c(sweepCase());
    addStep(c, "kill -KILL $PPID; sleep 1");
    EXPECT_EQ(c.run("workPrecision", "", 1, 60).code, 137);
    const auto rows = rowsOf(c);
    ASSERT_EQ(rows.size(), 1u);
    const auto second = c.run("workPrecision", "", 1, 60);
    EXPECT_EQ(second.code, 0) << second.err;
    EXPECT_EQ(rowsOf(c).size(), 2u);
    EXPECT_EQ(rowsOf(c).at("base,6"), rows.at("base,6"));
}

// One variant's walls are refused, one blows up, one is too slow: each is marked, the good one is measured, and the sweep ends well.
// A failed run is tried again, the others are not; the slow one is when it may take longer.
TEST(WorkPrecision, SurvivesRunsThatFail)
{
    const TestCase c(sweepCase());
    c.replace(dict, "resolutions (6 8);", "resolutions (6);\ntimeLimit 3;");
    c.replace(dict, "base { }",
              "base { }\n    refused { \"constant/geometry\" { walls { rod { type cylinder; point (0.5 0.5 0); radius 0.1; fluid "
              "outside; } } } }\n"
              "    blownUp { \"system/packParticlesDict\" { velocity { U 1e7; } } }\n"
              "    slow { \"system/controlDict\" { endTime 1e5; writeInterval 1000; } }");
    c.replace(dict, "{ field U.x; norm L2; }", "{ field U.x; norm L2; time 0.02; }");
    const auto outcome = c.run("workPrecision", "", 1, 60);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    expectWords(outcome.out, {"meshToGhost: exit code 1", "sphFoamLike: exit code 1: the solution has diverged: water has reached",
                              "sphFoamLike: stopped at the time limit", "1 of 4 runs ended well"});
    const auto rows = rowsOf(c);
    ASSERT_EQ(rows.size(), 4u);
    expectWords(rows.at("base,6"), {",ok,"});
    expectWords(rows.at("refused,6"), {",failed,"});
    expectWords(rows.at("blownUp,6"), {",diverged,"});
    expectWords(rows.at("slow,6"), {",timeLimit,"});

    const auto again = c.run("workPrecision", "-dry-run");
    expectWords(again.out, {"3 of them done already", "refused/6  to run"});
    c.replace(dict, "timeLimit 3;", "timeLimit 30;");
    expectWords(c.run("workPrecision", "-dry-run").out, {"2 of them done already"});
}

// An error at a time that is not sampled is a failure that says so; where no run ends well, so does workPrecision.
TEST(WorkPrecision, FailsWhereNoRunEndsWell)
{
    const TestCase c(sweepCase());
    c.replace(dict, "{ field U.x; norm L2; }", "{ field U.x; norm L2; time 0.035; }");
    const auto outcome = c.run("workPrecision", "", 1, 60);
    EXPECT_EQ(outcome.code, 1);
    expectWords(outcome.out, {"has no U.x at time 0.035: is it sampled then?", "0 of 2 runs ended well"});

    c.replace(dict, "time 0.035", "time 0");
    expectWords(c.run("workPrecision", "", 1, 60).out,
                {"at time 0 is not finite: it is relative to a reference of 0", "0 of 2 runs ended well"});
}

}
}
