/// Inlets and outlets that cannot be: refused with file and line before anything runs; numbers beyond sense end in an error or in finite fields.
#include "refusal.hpp"
#include <cmath>
#include <fmt/format.h>

namespace sph::test
{
namespace
{

const std::string file = "constant/openings";

const TestCase& goodDuct()
{
    static const auto made = firstWriteOf(openCase(), "ascii");
    return *made;
}

/// With one entry of constant/openings another.
void isRefusedWith(const std::string& from, const std::string& to, const std::vector<std::string>& words)
{
    SCOPED_TRACE(from + " -> " + to);
    Damaged c(goodDuct());
    c.replace(file, from, to);
    c.isRefused("sphFoamLike", words);
}

TEST(Openings, MissingAndUnknownWords)
{
    isRefusedWith("    type inlet;\n", "", {file + ":1: ", "\"type\" is missing"});
    isRefusedWith("type inlet", "type inlett", {file + ":3: ", "\"inlett\" is unknown", "Did you mean \"inlet\"?"});
    isRefusedWith("profile developed", "profile parabolic", {file + ":8: ", "\"parabolic\" is unknown", "uniform, developed"});
    isRefusedWith("    point (0 0 0);\n", "", {file + ":1: ", "\"point\" is missing"});
    isRefusedWith("    normal (1 0 0);\n", "", {file + ":1: ", "\"normal\" is missing"});
}

TEST(Openings, MisspeltEntries)
{
    isRefusedWith("velocity 3", "velocty 3", {file + ":6: ", "velocty", "Did you mean \"velocity\"?"});
    isRefusedWith("profile developed", "profil developed", {file + ":8: ", "profil", "Did you mean \"profile\"?"});
    isRefusedWith("pressure 100", "presure 100", {file + ":16: ", "presure", "Did you mean \"pressure\"?"});
    isRefusedWith("type outlet;", "type outlet; velocity 1;", {file + ":13: ", "\"velocity\" is not used"});
}

TEST(Openings, WhatDrivesTheFlow)
{
    isRefusedWith("velocity 3;", "velocity 3; flowRate 3;", {file + ":6: ", "flowRate", "velocity too"});
    isRefusedWith("    velocity 3;\n    pressure 3e4;\n", "", {file + ":1: ", "what drives the flow is missing"});
    isRefusedWith("velocity 3", "velocity -3", {file + ":6: ", "velocity"});
    isRefusedWith("velocity 3", "flowRate -3", {file + ":6: ", "flowRate"});
    isRefusedWith("velocity 3", "velocity 0", {file + ":6: ", "velocity"});
    isRefusedWith("velocity 3", "velocity [0 0 1 0 0 0 0] 3", {file + ":6: ", "dimensions"});
}

TEST(Openings, Powder)
{
    isRefusedWith("phi 0.45", "phi 0.68", {file + ":9: ", "less than phiMax"});
    isRefusedWith("phi 0.45", "phi -0.1", {file + ":9: ", "phi"});
    Damaged unknown(goodDuct());
    std::filesystem::remove(unknown.folder() / "constant/transportProperties");
    unknown.isRefused("sphFoamLike", {file + ":9: ", "has no suspension"});
}

TEST(Openings, PlanesThatAreNone)
{
    isRefusedWith("normal (1 0 0)", "normal (0 0 0)", {file + ":5: ", "must have a direction"});
    isRefusedWith("normal (1 0 0)", "normal (1 0 1)", {file + ":5: ", "in 2-D the z component"});
    isRefusedWith("point (0 0 0)", "point (0 0)", {file + ":4: ", "point"});
    isRefusedWith("point (0 0 0)", "point 0", {file + ":4: ", "point"});
    isRefusedWith("vent\n", "depth 3;\nvent\n", {file + ":11: ", "\"depth\" must be a dictionary"});
}

TEST(Openings, WhereThereIsNoDuct)
{
    isRefusedWith("point (0 0 0);", "point (0 0 0); min (0 1.2 0); max (0 1.5 0);",
                  {file + ":1: ", "\"gate\" has no fluid in its plane", "inside a wall"});
    isRefusedWith("point (0 0 0);", "point (0 0 0); min (0 0.42 0); max (0 0.43 0);",
                  {file + ":1: ", "less than the support of the kernel"});
    isRefusedWith("point (0 0 0);", "point (0 0 0); min (0 0.6 0); max (0 0.4 0);", {file + ":4: ", "max must not be less than min"});
    isRefusedWith("point (0 0 0)", "point (-0.15 0 0)", {file + ":1: ", "of domain beyond its plane"});
    isRefusedWith("point (1 0 0)", "point (7 0 0)", {file + ":11: ", "has no fluid in its plane"});
    isRefusedWith("normal (1 0 0)", "normal (1 0.5 0)", {file + ":1: ", "must go on straight"});
    isRefusedWith("point (1 0 0)", "point (0.1 0 0)", {file, "overlap"});
    isRefusedWith("point (1 0 0);\n    normal (-1 0 0)", "point (0 0 0);\n    normal (-1 0 0)", {file, "overlap"});
}

// Turned round, an inlet would hold and take away the scene in place of the duct: the other opening tells, or that there is nothing before the plane.
TEST(Openings, NormalsOutOfTheScene)
{
    isRefusedWith("normal (1 0 0)", "normal (-1 0 0)",
                  {file + ":1: ", "opening \"gate\" has \"vent\" beyond its plane", "its normal must point into the scene"});
    isRefusedWith("normal (-1 0 0)", "normal (1 0 0)", {file + ":11: ", "opening \"vent\" has \"gate\" beyond its plane"});
    const std::string vent = "vent\n{\n    type outlet;\n    point (1 0 0);\n    normal (-1 0 0);\n    pressure 100;\n}\n";
    Damaged alone(goodDuct());
    alone.replace(file, vent, "");
    alone.replace(file, "normal (1 0 0)", "normal (-1 0 0)");
    alone.isRefused("sphFoamLike",
                    {file + ":1: ", "opening \"gate\" has 0.2 m of scene before its plane, less than the 0.31 m that it holds beyond",
                     "its normal must point into the scene"});
}

// Where the domain goes on beyond it there is no telling a runner from a scene: what is taken away is in the log and in the balance.
TEST(Openings, CountWhatTheyTakeAway)
{
    auto files = openCase();
    auto& geometry = files["constant/geometry"];
    geometry.replace(geometry.find("min (-0.2"), 9, "min (-1");
    const TestCase c(files);
    c.runWell("packParticles");
    c.runWell("meshToGhost");
    const auto log = c.runWell("sphFoamLike");
    EXPECT_NE(log.find("120 particles held beyond its plane, 700 kg further beyond taken away at the start"), std::string::npos) << log;
    EXPECT_NE(log.find("kg with "), std::string::npos);
    EXPECT_NE(log.find(", took away 700 kg at the start"), std::string::npos);
    const auto balance = log.substr(log.rfind("balance: mass off by ") + 21);
    EXPECT_LT(std::abs(std::stod(balance)), 1e-14);
}

TEST(Openings, AcrossAPeriodicDirection)
{
    Damaged c(goodDuct());
    c.replace("constant/geometry", "max (1.2 1 0); }", "max (1.2 1 0); periodic (x); }");
    c.runWell("meshToGhost");
    c.isRefused("sphFoamLike", {file + ":5: ", "the domain is periodic in x"});
}

TEST(Openings, WithWhatTheyDoNotGoWith)
{
    Damaged creeping(goodDuct());
    creeping.replace("system/sphSchemes", "semiImplicit", "quasiSteady");
    creeping.replace("system/sphSchemes", "shifting 2", "shifting 0");
    creeping.isRefused("sphFoamLike", {file + ":1: ", "particles that move"});
}

// Which phase comes in must be said, and be there.
TEST(Openings, PhasesThatAreNone)
{
    const auto refused = [](const Files& files, const std::string& from, const std::string& to, const std::vector<std::string>& words)
    {
        SCOPED_TRACE(from + " -> " + to);
        auto damaged = files;
        auto& text = damaged[file];
        text.replace(text.find(from), from.size(), to);
        const TestCase c(damaged);
        const auto outcome = c.run("sphFoamLike", "-dry-run");
        EXPECT_EQ(outcome.code, 1);
        for (const auto& word : words) EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
    };
    const auto layers = layersCase(), drip = dripCase();
    refused(layers, "    phase water;\n", "", {file + ":1: ", "\"phase\" is missing", "Known phases: water, gas"});
    refused(layers, "phase water", "phase watr", {file + ":8: ", "\"watr\" is unknown. Did you mean \"water\"?"});
    refused(layers, "phase gas", "phase oil", {file + ":11: ", "\"oil\" is unknown", "water, gas"});
    refused(layers, "phase gas;", "", {file + ":11: ", "\"phase\" is missing"});
    refused(layers, "backflow gas", "backflow air", {file + ":20: ", "\"air\" is unknown", "water, gas"});
    refused(layers, "backflow gas", "backflw gas", {file + ":20: ", "Did you mean \"backflow\"?"});
    refused(drip, "    radius 0.15;\n", "", {file + ":1: ", "\"radius\" is missing"});
    refused(drip, "radius 0.15", "radius -0.15", {file + ":5: ", "radius"});
    refused(drip, "((0.5 1 0))", "()", {file + ":4: ", "a point at least"});
    refused(drip, "flowRate 0.12;", "", {file + ":1: ", "how much comes in is missing"});
    refused(drip, "flowRate 0.12;", "pressure 3;", {file + ":7: ", "\"pressure\" is not used"});
    refused(drip, "phase water;", "phase water; markFrom -1;", {file + ":8: ", "markFrom"});
}

// Where they cannot be: nearer to each other than they are wide, narrower than the kernel, in a wall.
TEST(Openings, DripsThatDoNotFit)
{
    const auto refused = [](const std::string& from, const std::string& to, const std::vector<std::string>& words)
    {
        SCOPED_TRACE(to);
        auto files = dripCase();
        auto& text = files[file];
        text.replace(text.find(from), from.size(), to);
        const TestCase c(files);
        c.runWell("packParticles");
        c.runWell("meshToGhost");
        const auto outcome = c.run("sphFoamLike");
        EXPECT_EQ(outcome.code, 1);
        for (const auto& word : words) EXPECT_NE(outcome.err.find(word), std::string::npos) << outcome.err;
    };
    refused("((0.5 1 0))", "((0.4 1 0) (0.6 1 0))", {file + ":1: ", "\"drip2\" overlaps \"drip1\""});
    refused("radius 0.15", "radius 0.05", {file + ":1: ", "\"drip1\" is 0.1 m wide, less than the support of the kernel"});
    refused("((0.5 1 0))", "((0.5 1.5 0))", {file + ":1: ", "\"drip1\" needs 0.44 m of domain beyond its plane"});
    refused("((0.5 1 0))", "((1.5 1 0))", {file + ":1: ", "\"drip1\" has no fluid in its plane"});
}

// An error, or a result without anything that is not finite.
TEST(Openings, NumbersBeyondSense)
{
    for (const std::string entry :
         {"velocity 3", "pressure 3e4", "phi 0.45", "pressure 100", "point (0 0 0)", "point (1 0 0)", "normal (1 0 0)"})
        for (const std::string number : {"nan", "inf", "-inf", "1e300", "-1e300", "1e-300"})
        {
            const auto at = entry.find_first_of(" (");
            const bool vector = entry.find('(') != std::string::npos;
            const auto text = entry.substr(0, at) + (vector ? " (" + number + " 0 0)" : " " + number);
            SCOPED_TRACE(entry + " -> " + text);
            Damaged c(goodDuct());
            c.replace(file, entry + ";", text + ";");
            const auto outcome = c.run("sphFoamLike");
            EXPECT_TRUE(outcome.code == 0 || outcome.code == 1) << outcome.code << outcome.err;
            EXPECT_EQ(outcome.code == 1, outcome.err.find("--> FATAL ERROR") != std::string::npos) << outcome.err;
            EXPECT_EQ(outcome.out.find("nan"), std::string::npos) << outcome.out;
            EXPECT_EQ(outcome.out.find("inf "), std::string::npos) << outcome.out;
            EXPECT_TRUE(outcome.code == 1 || number.find('n') == std::string::npos) << outcome.out;
        }
}

}
}
