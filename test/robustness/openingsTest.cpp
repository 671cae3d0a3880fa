/// Inlets and outlets that cannot be: refused with file and line before anything runs; numbers beyond sense end in an error or in finite fields.
#include "case/Case.hpp"
#include "case/Cloud.hpp"
#include "refusal.hpp"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

namespace sph::test::openingsTest
{
namespace
{

const std::string file = "constant/openings";

const TestCase& goodDuct()
{
    static const auto made = firstWriteOf(openCase(), "ascii");
    return *made;
}

/// Expects an error from the duct with one entry of constant/openings replaced by another.
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
                  {file + ":1: ", "opening \"gate\" has \"vent\" beyond its plane", "its normal, (-1 0 0), must point into the scene"});
    isRefusedWith("normal (-1 0 0)", "normal (1 0 0)", {file + ":11: ", "opening \"vent\" has \"gate\" beyond its plane"});
    const std::string vent = "vent\n{\n    type outlet;\n    point (1 0 0);\n    normal (-1 0 0);\n    pressure 100;\n}\n";
    Damaged alone(goodDuct());
    alone.replace(file, vent, "");
    alone.replace(file, "normal (1 0 0)", "normal (-1 0 0)");
    alone.isRefused("sphFoamLike",
                    {file + ":1: ", "opening \"gate\" has 0.2 m of scene before its plane, less than the 0.31 m that it holds beyond",
                     "its normal, (-1 0 0), must point into the scene"});
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

/// Density over that at rest of particles within `reach` beyond a plane, of the last time folder.
struct Range
{
    std::size_t particles = 0;
    double least = 1e9, largest = 0;
};
Range densityBeyond(const TestCase& c, const Vector<3>& point, const Vector<3>& normal, double reach, const std::vector<double>& atRest)
{
    const Case theCase(c.folder());
    const auto cloud = readCloud(theCase.folder(), theCase.times().back(), "sph", theCase.diagnostics(),
                                 {{"phase", FieldClass::label}, {"m", FieldClass::scalar}, {"rho", FieldClass::scalar}});
    theCase.diagnostics().throwIfAny();
    Range range;
    for (std::size_t i = 0; i < cloud.size(); ++i)
    {
        const double s = dot(Vector<3>{cloud.x[i], cloud.y[i], cloud.z[i]} - point, normal);
        if (s > 0 || s < -reach) continue;
        const auto& phase = cloud.fields.at("phase").component[0];
        const double ratio = cloud.fields.at("rho").component[0][i] / atRest[std::size_t(phase[i])];
        ++range.particles;
        range.least = std::min(range.least, ratio);
        range.largest = std::max(range.largest, ratio);
    }
    return range;
}

/// Of the last report of an opening: what it lets in and was asked for.
struct Rate
{
    double reached = 0, asked = 0, passed = 0;
};
double passedBy(const std::string& log, const std::string& name)
{
    const auto line = log.substr(log.rfind("\n" + name + ": "));
    return std::stod(line.substr(line.find("passed ") + 7));
}
Rate rateOf(const std::string& log, const std::string& name)
{
    const auto line = log.substr(log.rfind("\n" + name + ": ") + name.size() + 3);
    const auto after = [&](const std::string& word) { return std::stod(line.substr(line.find(word) + word.size())); };
    return {std::stod(line), after(" for "), passedBy(log, name)};
}

// Drips of 2 to 8 spacings, anywhere beside the lattice of the duct: what the scene sees of what is held is within 2 % of its density at rest and the rate is that asked for,
// or the drip is refused with what would do.
TEST(Openings, DripsOfAllWidths)
{
    const double spacing = 0.05, H = 2.6 * spacing;
    for (const double width : {2.0, 2.5, 2.7, 3.0, 3.4, 4.0, 4.5, 5.3, 6.6, 8.0})
        for (const double offset : {0.0, 0.3, 0.5})
        {
            SCOPED_TRACE(fmt::format("{} spacings, {} off", width, offset));
            auto files = dripCase();
            auto& control = files["system/controlDict"];
            control.replace(control.find("0.08"), 4, "1e-4");
            control.replace(control.find("0.02"), 4, "1e-4");
            auto& openings = files[file];
            openings.replace(openings.find("(0.5 1 0)"), 9, fmt::format("({} 1 0)", 0.5 + offset * spacing));
            openings.replace(openings.find("radius 0.15"), 11, fmt::format("radius {}", 0.5 * width * spacing));
            const TestCase c(files);
            c.runWell("packParticles");
            c.runWell("meshToGhost");
            const auto outcome = c.run("sphFoamLike");
            if (width < 2.6)
            {
                EXPECT_EQ(outcome.code, 1);
                EXPECT_NE(outcome.err.find(file + ":1: opening \"drip1\" is "), std::string::npos) << outcome.err;
                EXPECT_NE(outcome.err.find("choose a spacing of at most"), std::string::npos) << outcome.err;
                continue;
            }
            ASSERT_EQ(outcome.code, 0) << outcome.err;
            const auto held = densityBeyond(c, {0, 1, 0}, {0, -1, 0}, H, {100, 1});
            EXPECT_GT(held.particles, 40u);
            EXPECT_GT(held.least, 0.98);
            EXPECT_LT(held.largest, 1.02);
            const auto rate = rateOf(outcome.out, "drip1");
            EXPECT_NEAR(rate.reached / rate.asked, 1, 0.01);
            EXPECT_EQ(rate.asked, 0.12);
        }
}

// The same in three dimensions: round drips beside grains, boxes in a square duct, and round pipes that were packed evenly.
TEST(Openings, InletsOfSeveralShapes)
{
    const double spacing = 0.1, H = 2.6 * spacing;
    struct Shape
    {
        std::string walls, openings, packing;
        double low, high, area; ///< of the domain across [m], and of the inlet [m^2]
    };
    std::vector<Shape> shapes;
    for (const double diameter : {3.0, 4.4, 6.0})
        shapes.push_back(
            {"grain { type sphere; centre (0.7 0.45 0.45); radius 0.3; fluid outside; } side { type box; min (-9 -0.5 -0.5); max (9 0.5 0.5); "
             "fluid inside; }",
             fmt::format(
                 "in {{ type drip; points ((0 0.03 -0.04)); radius {}; normal (1 0 0); velocity 1; }} sky {{ type outlet; point (0 0 0); normal (1 0 0); backflow water; }}",
                 0.05 * diameter),
             "relax { steps 100; }", -0.5, 0.5, std::numbers::pi / 4 * sqr(0.1 * diameter)});
    for (const double offset : {0.0, 0.037})
        shapes.push_back(
            {"side { type box; min (-9 -0.5 -0.5); max (9 0.5 0.5); fluid inside; }",
             fmt::format(
                 "in {{ type inlet; point (0 0 0); normal (1 0 0); min (0 {} -0.5); max (0 {} 0.5); velocity 1; profile uniform; }}",
                 -0.3 + offset, 0.13 + offset),
             "fill ( { region box; min (-0.1 -0.1 -0.1); max (0 0.1 0.1); phase water; } );", -0.5, 0.5, 0.43});
    for (const double diameter : {5.3, 6.4, 8.0}) // narrower ones are refused as walls
        shapes.push_back({fmt::format("side {{ type cylinder; point (0 0 0); axis (1 0 0); radius {}; fluid inside; }}", 0.05 * diameter),
                          "in { type inlet; point (0 0 0); normal (1 0 0); velocity 1; profile uniform; }", "relax { steps 200; }",
                          -0.05 * diameter, 0.05 * diameter, std::numbers::pi / 4 * sqr(0.1 * diameter)});
    for (const auto& [walls, openings, packing, low, high, area] : shapes)
    {
        SCOPED_TRACE(openings + walls);
        auto files = channelCase();
        auto& control = files["system/controlDict"];
        control.replace(control.find("0.08"), 4, "1e-4");
        control.replace(control.find("0.02"), 4, "1e-4");
        files["system/sphSchemes"] = "resolution { spacing 0.1; support 2.6; kernel wendlandC2; }\nintegration { scheme semiImplicit; }\n";
        files["system/packParticlesDict"] = "lattice cubic; allowEmpty yes; " + packing + "\n";
        files["constant/geometry"] =
            fmt::format("dimension 3; domain {{ min (-0.7 {0} {0}); max (1.2 {1} {1}); }}\nwalls {{ {2} }}\n", low, high, walls);
        files.erase("constant/g");
        files[file] = openings;
        const TestCase c(files);
        c.runWell("packParticles");
        c.runWell("meshToGhost");
        const auto log = c.runWell("sphFoamLike");
        const bool isAlone = packing.starts_with("fill"), isDrip = openings.find("drip") != std::string::npos;
        const auto rate = rateOf(log, isDrip ? "in1" : "in");
        EXPECT_NEAR(rate.reached / rate.asked, 1, 0.01);
        EXPECT_NEAR(rate.asked / area, 1, 0.01);
        if (isAlone) continue; // a jet in the open is thin at its edges
        const auto held = densityBeyond(c, {0, 0, 0}, {1, 0, 0}, H, {1000});
        EXPECT_GT(held.particles, 20u);
        EXPECT_LT(held.largest, 1.02);
        EXPECT_GT(held.least, 0.98);
    }
}

// A jet into an empty duct through a part of its section, 100 rows long: what has passed is the rate asked for times the time, within 1 %, of which half a row is half.
TEST(Openings, PartsOfADuctLetInWhatIsAsked)
{
    for (const double offset : {0.0, 0.013, 0.031})
    {
        SCOPED_TRACE(offset);
        auto files = channelCase();
        auto& control = files["system/controlDict"];
        control.replace(control.find("0.08"), 4, "1");
        control.replace(control.find("0.02"), 4, "1");
        files["system/sphSchemes"] = "resolution { spacing 0.05; support 2.6; kernel wendlandC2; }\nintegration { scheme semiImplicit; }\n";
        files["system/packParticlesDict"] =
            "allowEmpty yes; fill ( { region box; min (-0.05 0.15 0.15); max (0 0.25 0.25); phase water; } );\n";
        files["constant/geometry"] =
            "dimension 3; domain { min (-0.3 0 0); max (9 0.4 0.4); }\nwalls { side { type box; min (-99 0 0); max (99 0.4 0.4); fluid "
            "inside; } }\n";
        files["constant/phaseProperties"] = "phases (water);\nwater { rho 1000; mu 10; soundSpeed 10; }\n";
        files.erase("constant/g");
        files[file] =
            fmt::format("in {{ type inlet; point (0 0 0); normal (1 0 0); min (0 {} {}); max (0 {} {}); velocity 5; profile uniform; }}\n",
                        0.1 + offset, 0.12 - offset, 0.27 + offset, 0.3);
        const TestCase c(files);
        c.runWell("packParticles");
        c.runWell("meshToGhost");
        const auto log = c.runWell("sphFoamLike", "", 1, 300);
        const auto rate = rateOf(log, "in");
        EXPECT_NEAR(rate.asked, 5 * 0.17 * (0.18 + offset), 1e-6);
        EXPECT_NEAR(rate.reached / rate.asked, 1, 0.01);
        EXPECT_NEAR(rate.passed / 1000 / rate.asked, 1, 0.01);
    }
}

// What openings hold is named apart: the log's masses and densities, a mean over the whole domain, of a run and of its stored times, and the volume of a surface are of the
// channel of 1 m^2 between the planes alone; what is held has 0.4 m^2 more.
TEST(Openings, AreNoPartOfTheScene)
{
    auto files = openCase();
    auto& control = files["system/controlDict"];
    control +=
        "functions { everywhere { type volFieldValue; operation volAverage; fields (p); } between { type volFieldValue; operation volAverage; fields (p); "
        "min (0 -9 -9); max (1 9 9); } }\n";
    files["system/reconstructSurfaceDict"] = "phases (feedstock);\n";
    const TestCase c(files);
    c.runWell("packParticles");
    c.runWell("meshToGhost");
    const auto log = c.runWell("sphFoamLike");
    const auto massAfter = [&](const std::string& word)
    {
        const auto line = log.substr(log.rfind(word));
        return std::stod(line.substr(line.find(", mass ") + 7));
    };
    EXPECT_NEAR(massAfter("\nfeedstock: rho "), 1000 + rateOf(log, "gate").passed + passedBy(log, "vent"), 1e-6);
    EXPECT_GT(massAfter("\nheld beyond openings: feedstock: rho "), 300);
    const auto table = [&](const std::string& name) { return c.read("postProcessing/" + name + "/0/volFieldValue.dat"); };
    EXPECT_EQ(table("everywhere"), table("between"));
    std::filesystem::remove_all(c.folder() / "postProcessing");
    c.runWell("sphPostProcess");
    EXPECT_EQ(table("everywhere"), table("between"));
    const auto surfaces = c.runWell("reconstructSurface", "--latestTime");
    const auto volume = surfaces.substr(surfaces.find("area [m^2] ") + 11);
    EXPECT_NEAR(std::stod(volume), 1, 0.05) << surfaces;
    EXPECT_NE(surfaces.find(" more held beyond openings)"), std::string::npos) << surfaces;
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
