#include "Particles.hpp"
#include "base/CaseError.hpp"
#include "geometry/PatchTree.hpp"
#include "geometry/Plane.hpp"
#include "geometry/Sphere.hpp"
#include "sampling/Conservation.hpp"
#include <atomic>
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>
#include <omp.h>
#include <random>
#include <set>
#include <sstream>

using namespace sph;

namespace
{

/// Function objects of a case of their own, from the text of `functions`.
struct Functions
{
    TemporaryCase folder;
    Case theCase{folder.folder()};
    RunTime time{theCase};

    FunctionObjects make(const Particles& particles, const std::string& text)
    {
        return {Dictionary::parse(text, "system/controlDict", theCase.sharedDiagnostics()), particles.geometry, particles.phases, time};
    }
    std::string mistakes() const { return errorsOf(theCase.diagnostics()); }
    void run(const Particles& particles, const std::string& text)
    {
        auto functions = make(particles, text);
        ASSERT_EQ(mistakes(), "");
        reports = functions.execute(particles.view(), time, true, false);
    }
    std::vector<std::string> reports;
};

}

TEST(FunctionObjects, unknownTypesAndUnusedEntriesAreErrorsAllAtOnce)
{
    Functions f;
    f.make(
        Particles(2, {0, 0, 0}, {1, 1, 0}, 0.5),
        "a\n{\n    type probs;\n}\nb\n{\n    type conservation;\n    angularMoment yes;\n}\nc 3;\nd { type conservation; origin (1 0 0); }\n");
    EXPECT_EQ(
        f.mistakes(),
        "system/controlDict:3: type \"probs\" is unknown. Did you mean \"probes\"? Known type: probes, profile, conservation, "
        "bedHydrodynamics, errors, filling, reduction, contour, surfaceIntegral, volFieldValue, forces.\n"
        "system/controlDict:8: entry \"angularMoment\" is not used here. Did you mean \"angularMomentum\"? Known entries: libs, type, "
        "executeControl, executeInterval, angularMomentum, origin.\n"
        "system/controlDict:10: c must be a dictionary: c { type ...; }\n"
        "system/controlDict:11: origin does nothing without angularMomentum, which counts from it: give `angularMomentum yes`, or leave it "
        "out\n"
        "4 errors");
}

// Libraries that are not there, and files that are none, are errors at their line; test/package/run has those that load, and those of another version.
TEST(FunctionObjects, librariesThatCannotBeLoadedAreErrors)
{
    Functions f;
    std::ofstream(f.theCase.folder() / "notes.so") << "no library";
    const auto folder = std::filesystem::absolute(f.theCase.folder()).string();
    std::ofstream(f.theCase.folder() / "system/libraries")
        << "a\n{\n    libs (missing \"$FOAM_CASE/notes.so\" \"none/libx.so\");\n    type conservation;\n}\n";
    const auto dict = f.theCase.dictionary("system/libraries");
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.5);
    const FunctionObjects functions(dict, particles.geometry, particles.phases, f.time);
    const auto said = f.mistakes();
    EXPECT_NE(said.find("system/libraries:3: library \"missing\": it is in none of " + folder), std::string::npos) << said;
    EXPECT_NE(said.find(
                  "system/libraries:3: library \"$FOAM_CASE/notes.so\": it is no library of function objects: none of its sources includes "
                  "sampling/functionLibrary.hpp"),
              std::string::npos)
        << said;
    EXPECT_NE(said.find("system/libraries:3: library \"none/libx.so\": there is no " + folder + "/none/libx.so"), std::string::npos)
        << said;
    EXPECT_TRUE(said.ends_with("3 errors")) << said;
}

TEST(FunctionObjects, haveNamesThatAreNoPaths)
{
    Functions f;
    std::ofstream(f.theCase.folder() / "system/named") << "\"../a\" { type conservation; }\n\".b\" { type conservation; }\n";
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.5);
    const FunctionObjects functions(f.theCase.dictionary("system/named"), particles.geometry, particles.phases, f.time);
    const auto said = f.mistakes();
    EXPECT_NE(said.find("system/named:1: names the folder of its output"), std::string::npos) << said;
    EXPECT_NE(said.find("system/named:2: names the folder of its output"), std::string::npos) << said;
}

TEST(FunctionObjects, areDueWhenTheirControlSays)
{
    // Steps of 0.1, every second step a write time, six steps; which steps have a row is what each control means.
    Functions f;
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.5);
    auto functions = f.make(particles, "w { type conservation; }\n"
                                       "w2 { type conservation; executeInterval 2; }\n"
                                       "s { type conservation; executeControl timeStep; executeInterval 3; }\n"
                                       "r { type conservation; executeControl runTime; executeInterval 0.25; }\n"
                                       "e { type conservation; executeControl onEnd; }\n");
    ASSERT_EQ(f.mistakes(), "");
    for (int step = 1; step <= 6; ++step)
    {
        f.time.advance(0.1);
        particles.time = f.time.value();
        const bool write = step % 2 == 0, end = step == 6;
        EXPECT_EQ(functions.due(f.time, write, end), step > 1) << step;
        functions.execute(particles.view(), f.time, write, end);
    }
    const auto times = [&](const std::string& name)
    {
        std::vector<int> steps;
        for (const auto& row : f.folder.rows("postProcessing/" + name + "/0/conservation.dat"))
            steps.push_back(int(std::lround(10 * std::stod(row[0]))));
        return steps;
    };
    EXPECT_EQ(times("w"), (std::vector{2, 4, 6}));
    EXPECT_EQ(times("w2"), (std::vector{2, 6}));
    EXPECT_EQ(times("s"), (std::vector{3, 6}));
    EXPECT_EQ(times("r"), (std::vector{3, 5}));
    EXPECT_EQ(times("e"), (std::vector{6}));
}

TEST(FunctionObjects, noneLeaveNoFiles)
{
    Functions f;
    const Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.5);
    EXPECT_TRUE(f.make(particles, "").empty());
    EXPECT_FALSE(f.make(particles, "a { type conservation; }").empty());
    EXPECT_FALSE(std::filesystem::exists(f.folder.folder() / "postProcessing"));
}

TEST(Probes, writeOpenFoamsFormat)
{
    // Linear fields, which the interpolation reproduces to round-off.
    Functions f;
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.05);
    particles.setP([](Vector<3>) { return 2.0; });
    particles.setU([](Vector<3> x) { return Vector<3>{4 * x.x, 0, 0}; });
    f.run(particles, "points { type probes; fields (U p); probeLocations ((0.5 0.5 0) (0.25 1 0)); }");
    const auto U = f.folder.read("postProcessing/points/0/U");
    EXPECT_TRUE(U.starts_with("# Probe 0 (0.5 0.5 0)\n# Probe 1 (0.25 1 0)\n# Time\t0\t1\n0\t(")) << U;
    const auto u = f.folder.rows("postProcessing/points/0/U").at(0), p = f.folder.rows("postProcessing/points/0/p").at(0);
    ASSERT_EQ(u.size(), 3u);
    EXPECT_NEAR(std::stod(u[1].substr(1)), 2, 1e-12);
    EXPECT_NEAR(std::stod(u[2].substr(1)), 1, 1e-12);
    EXPECT_TRUE(u[1].ends_with(" 0)")) << u[1];
    EXPECT_NEAR(std::stod(p[1]), 2, 1e-12);
}

// The left three tenths of a square are full, then seven tenths: 0.3 of its volume, and what lies within a spacing of the front too.
TEST(Filling, tellsHowMuchIsFilledAndWhen)
{
    Functions f;
    Particles particles(2, {0, 0, 0}, {0.3, 1, 0}, 0.05);
    particles.geometry.high = {1, 1, 0};
    auto functions = f.make(particles, "cavity { type filling; level 0.7; }");
    ASSERT_EQ(f.mistakes(), "");
    const auto sample = [&](double t)
    {
        f.time.advance(t - f.time.value());
        particles.time = f.time.value();
        return functions.execute(particles.view(), f.time, true, false).at(0);
    };
    EXPECT_EQ(sample(1), "cavity: 0.3000 of the cavity by volume, 0.3500 reached, not filled yet");
    for (double x = 0.325; x < 0.7; x += 0.05)
        for (double y = 0.025; y < 1; y += 0.05) particles.add({x, y, 0});
    EXPECT_EQ(sample(2), "cavity: 0.7000 of the cavity by volume, 0.7500 reached, filled to 0.7 at 2 s");
    EXPECT_EQ(sample(3), "cavity: 0.7000 of the cavity by volume, 0.7500 reached, filled to 0.7 at 2 s");
    const auto rows = f.folder.rows("postProcessing/cavity/0/filling.dat");
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_NEAR(std::stod(rows[0][1]), 0.3, 1e-12);
}

TEST(Filling, countsWhatWallsLeave)
{
    Functions f;
    Particles particles(3, {0, 0, 0}, {1, 1, 1}, 0.1);
    particles.geometry.originals.push_back({std::make_shared<Plane>(Vector<3>{0.5, 0, 0}, Vector<3>{-1, 0, 0}), 0});
    particles.geometry.walls.emplace_back();
    repeatPeriodically(particles.geometry, 0.3);
    f.run(particles, "cavity { type filling; min (0 0 0); max (1 0.5 1); }");
    EXPECT_EQ(f.reports.at(0), "cavity: 2.0000 of the cavity by volume, 1.0000 reached, filled to 0.99 at 0 s");
}

// A ball in a box that is no whole number of spacings long, 6 and 12 spacings to its radius: shares of cells have 0.4 and 0.2 % more than its volume. Whole
// cells, those whose middle is in it, have 2.5 % more with 6.
TEST(Filling, hasTheVolumeOfTheCavity)
{
    for (const double n : {6.0, 12.0})
    {
        Functions f;
        Particles particles(3, {0, 0, 0}, {2.3, 2.3, 2.3}, 1 / n);
        particles.geometry.originals.push_back({std::make_shared<Sphere>(Vector<3>{1.15, 1.15, 1.15}, 1.0, FluidSide::inside), 0});
        particles.geometry.walls.emplace_back();
        repeatPeriodically(particles.geometry, 0.5);
        f.run(particles, "cavity { type filling; }");
        double volume = 0;
        const auto view = particles.view();
        for (std::size_t i = 0; i < view.n; ++i) volume += view.mass[i] / view.restDensity[0];
        const double filled = std::stod(f.folder.rows("postProcessing/cavity/0/filling.dat").at(0).at(1));
        EXPECT_NEAR(volume / filled / (4.0 / 3.0 * std::numbers::pi), 1, n == 6 ? 5e-3 : 2e-3);
    }
}

TEST(VolFieldValue, isTheMeanOrAnExtremeOverABox)
{
    Functions f;
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.05);
    particles.setP([](Vector<3> x) { return 3 * x.y; });
    f.run(particles, "mean { type volFieldValue; operation volAverage; fields (p U); min (0 0 0); max (1 0.5 0); }\n"
                     "most { type volFieldValue; operation max; fields (p); }\n"
                     "none { type volFieldValue; operation min; fields (p); min (0.51 0.51 0); max (0.52 0.52 0); }");
    EXPECT_NEAR(std::stod(f.folder.rows("postProcessing/mean/0/volFieldValue.dat").at(0).at(1)), 0.75, 1e-12);
    EXPECT_EQ(f.reports.at(1), "most: max p 2.925");
    EXPECT_EQ(f.reports.at(2), "none: min p nan");
}

TEST(VolFieldValue, needsABoxThatIsOne)
{
    Functions f;
    f.make(Particles(2, {0, 0, 0}, {1, 1, 0}, 0.5),
           "a\n{\n    type volFieldValue;\n    operation sum;\n    fields (p);\n    min (0 1 0);\n}\n");
    const auto mistakes = f.mistakes();
    EXPECT_NE(mistakes.find("max must be greater than min; in y it is 1 against 1"), std::string::npos) << mistakes;
    EXPECT_NE(mistakes.find("\"sum\" is unknown"), std::string::npos) << mistakes;
}

TEST(Probes, outsideTheDomainAreAnError)
{
    Functions f;
    f.make(Particles(2, {0, 0, 0}, {1, 1, 0}, 0.5),
           "points\n{\n    type probes;\n    fields (p);\n    probeLocations ((0 0 0) (2 0 0));\n}\n");
    EXPECT_EQ(f.mistakes(), "system/controlDict:5: probe 1 at (2 0 0) lies outside the domain from (0 0 0) to (1 1 0)");
}

TEST(Profile, samplesALine)
{
    Functions f;
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.05);
    particles.setP([](Vector<3> x) { return 3 * x.y; });
    f.run(particles, "line { type profile; start (0.5 0.1 0); end (0.5 0.9 0); nPoints 5; fields (p U); }");
    EXPECT_TRUE(f.folder.read("postProcessing/line/0/line_p_U.xy").starts_with("# distance\tp\tU_x\tU_y\tU_z\n"));
    const auto rows = f.folder.rows("postProcessing/line/0/line_p_U.xy");
    ASSERT_EQ(rows.size(), 5u);
    EXPECT_NEAR(std::stod(rows[4][0]), 0.8, 1e-15);
    EXPECT_NEAR(std::stod(rows[1][1]), 0.9, 1e-12);
}

// Expressions of linear fields are linear, and interpolated to round-off.
TEST(Profile, samplesExpressions)
{
    Functions f;
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.05);
    particles.setP([](Vector<3> x) { return 3 * x.y; });
    f.run(
        particles,
        "line { type profile; start (0.5 0.1 0); end (0.5 0.9 0); nPoints 5; fields (p); expressions { head \"2*$p + $x\"; slope \"grad($p)\"; } }");
    EXPECT_TRUE(
        f.folder.read("postProcessing/line/0/line_p_head_slope.xy").starts_with("# distance\tp\thead\tslope_x\tslope_y\tslope_z\n"));
    const auto row = f.folder.rows("postProcessing/line/0/line_p_head_slope.xy").at(1);
    EXPECT_NEAR(std::stod(row[2]), 2.3, 1e-12);
    EXPECT_NEAR(std::stod(row[3]), 0, 1e-11);
    EXPECT_NEAR(std::stod(row[4]), 3, 1e-11);
    Functions slabs;
    slabs.run(particles, "cells { type profile; start (0 0 0); end (0 1 0); bins 2; expressions { twice \"2*$p\"; } }");
    EXPECT_NEAR(std::stod(slabs.folder.rows("postProcessing/cells/0/bins_twice.xy").at(0).at(1)), 1.5, 1e-12);
}

TEST(Probes, sampleExpressions)
{
    Functions f;
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.05);
    particles.setU([](Vector<3> x) { return Vector<3>{4 * x.x, 0, 0}; });
    f.run(particles, "points { type probes; expressions { half \"$U/2\"; sum \"$U_x + $y\"; } probeLocations ((0.5 0.25 0)); }");
    EXPECT_NEAR(std::stod(f.folder.rows("postProcessing/points/0/half").at(0).at(1).substr(1)), 1, 1e-12);
    EXPECT_NEAR(std::stod(f.folder.rows("postProcessing/points/0/sum").at(0).at(1)), 2.25, 1e-12);
}

TEST(Probes, refuseExpressionsThatAreNone)
{
    Functions f;
    f.make(Particles(2, {0, 0, 0}, {1, 1, 0}, 0.5),
           "points\n{\n    type probes;\n    fields (p);\n    expressions { p \"$p\"; a \"$p +\"; }\n    probeLocations ((0 0 0));\n}\n"
           "none\n{\n    type probes;\n    probeLocations ((0 0 0));\n}\n");
    for (const char* part : {"system/controlDict:5: p is the name of a field that is sampled as well: give the expression another one",
                             "a \"$p +\": a value is missing at the end", "fields"})
        EXPECT_NE(f.mistakes().find(part), std::string::npos) << part << "\nin\n" << f.mistakes();
}

TEST(Profile, binsAreVolumeWeightedMeans)
{
    // Two slabs of height 1/2; in the lower one the particle of volume 3 counts three times.
    Functions f;
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.5);
    particles.volume = {1, 3, 1, 1};
    particles.p = {4, 8, 1, 2};
    f.run(particles, "cells { type profile; start (0 0 0); end (0 1 0); bins 2; fields (p); }");
    const auto rows = f.folder.rows("postProcessing/cells/0/bins_p.xy");
    ASSERT_EQ(rows.size(), 2u);
    EXPECT_EQ(rows[0], (std::vector<std::string>{"0.25", "7", "2"}));
    EXPECT_EQ(rows[1], (std::vector<std::string>{"0.75", "1.5", "2"}));
}

TEST(Conservation, sumsAreThoseByHand)
{
    // Masses 1 and 2 at (1, 0) and (0, 3), u = (1, 2) and (-1, 0), g = (0, -10): m g y = 60.
    Particles particles(2, {0, 0, 0}, {0, 0, 0}, 1);
    particles.add({1, 0, 0});
    particles.add({0, 3, 0});
    particles.mass = {1, 2};
    particles.ux = {1, -1};
    particles.uy = {2, 0};
    particles.g = {0, -10, 0};
    particles.phases = {"water", "air"};
    particles.phase = {0, 1};
    auto s = Conservation::sums(particles.view(), {}, {});
    EXPECT_EQ(s.mass, (std::vector<double>{1, 2}));
    EXPECT_EQ(s.momentum, (Vector<3>{-1, 2, 0}));
    EXPECT_EQ(s.kineticEnergy, 3.5);
    EXPECT_EQ(s.potentialEnergy, 60);
    EXPECT_EQ(s.angularMomentum, (Vector<3>{0, 0, 8}));
    // A force of 4 N/m^3 along -y on a volume of 5 m^3 at y = 3: 60 J more, whatever the densities of the phases.
    auto view = particles.view();
    const double volume[]{7, 5};
    view.volume = volume;
    view.bodyForce = {0, -4, 0};
    EXPECT_EQ(Conservation::sums(view, {}, {}).potentialEnergy, 120);
    particles.geometry.periodic = {false, true, false};
    EXPECT_EQ(Conservation::sums(particles.view(), {}, {}).potentialEnergy, 0);
    // The second held beyond an opening: no part of the scene.
    particles.heldBy = {0, 1};
    s = Conservation::sums(particles.view(), {}, {});
    EXPECT_EQ(s.mass, (std::vector<double>{1, 0}));
    EXPECT_EQ(s.momentum, (Vector<3>{1, 2, 0}));
    EXPECT_EQ(s.kineticEnergy, 2.5);
}

TEST(Conservation, writesAllDigitsAndReportsTheChange)
{
    Functions f;
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.5);
    particles.mass = {0.1, 0.2, 1.0 / 3, 0.4};
    particles.setU([](Vector<3>) { return Vector<3>{1, 0, 0}; });
    auto functions = f.make(particles, "sums { type conservation; angularMomentum yes; }");
    functions.execute(particles.view(), f.time, true, false);
    particles.mass[0] = 0.2;
    const auto reports = functions.execute(particles.view(), f.time, true, false);
    EXPECT_EQ(reports.at(0),
              "sums: relative change of mass 0.0968; change of momentum 0.1 kg m/s, of kinetic and potential energy 0.05 J, by all forces");
    const auto text = f.folder.read("postProcessing/sums/0/conservation.dat");
    EXPECT_NE(text.find("# Time\tmass_water\tmomentum\tkineticEnergy\tpotentialEnergy\tangularMomentum\n"), std::string::npos) << text;
    const double mass = ((0.1 + 0.2) + 1.0 / 3) + 0.4;
    EXPECT_EQ(std::stod(f.folder.rows("postProcessing/sums/0/conservation.dat").at(0).at(1)), mass);
}

// Balances are 0 where the forces' impulse and work account for all, in a fall that starts from rest too, where the momentum and the energy
// of the first sample are 0; what is missing is a share of what was given, whatever the sign. Hand values, exact in binary.
TEST(Conservation, balancesWithImpulseAndWork)
{
    Functions f;
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.5);
    particles.mass = {1, 1, 1, 1};
    particles.setU([](Vector<3>) { return Vector<3>{}; });
    auto functions = f.make(particles, "sums { type conservation; }");
    const auto report = [&](Vector<3> u, const Supply& supply)
    {
        particles.setU([=](Vector<3>) { return u; });
        auto view = particles.view();
        view.supply = supply;
        return functions.execute(view, f.time, true, false).at(0);
    };
    report({}, {{1, 1, 0}, 3, 5}); // a run that began before
    EXPECT_EQ(report({0, -2, 0}, {{1, -7, 0}, 11, 5}),
              "sums: relative change of mass 0, of momentum 0 beyond the impulse of gravity and body force, of "
              "energy 0 beyond their work");
    EXPECT_EQ(report({0, -1, 0}, {{1, -7, 0}, 11, 6}),
              "sums: relative change of mass 0, of momentum 0.5 beyond the impulse of gravity and body force, "
              "of energy -0.625 beyond their work (dissipated)");
    EXPECT_EQ(report({}, {{1, -15, 0}, 19, 5}),
              "sums: relative change of mass 0, of momentum 1 beyond the impulse of gravity and body force, of energy "
              "-1 beyond their work (dissipated)");
    EXPECT_EQ(report({0, -2, 0}, {{1, -7, 0}, 3, 13}),
              "sums: relative change of mass 0, of momentum 0 beyond the impulse of gravity and body force, of "
              "energy 1 beyond their work");
}

// A drop at rest whose surface shrinks by 8 J, of which 2 J are left as motion: 0.75 of what the surface gave is dissipated. What a moving wall has given
// the log does not take for the scheme's, unless its work is counted; nor what a wall gives as it is wetted. A wall at
// rest gives nothing.
TEST(Conservation, saysWhatInterfacesAndWallsGave)
{
    enum Wall
    {
        none,
        atRest,
        moving,
        counted,
        wet
    };
    for (const auto wall : {none, atRest, moving, counted, wet})
    {
        const bool isNamed = wall == moving || wall == wet;
        Functions f;
        Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.5);
        particles.mass = {1, 1, 1, 1};
        if (wall != none)
        {
            particles.geometry.patches = {{std::make_shared<Plane>(Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}), 0}};
            particles.geometry.walls.resize(1);
            if (wall == moving || wall == counted) particles.geometry.walls[0].velocity = {1, 0, 0};
            particles.geometry.walls[0].wets = wall == wet;
        }
        auto functions = f.make(particles, "sums { type conservation; }");
        const auto report = [&](Vector<3> u, const Supply& supply)
        {
            particles.setU([=](Vector<3>) { return u; });
            auto view = particles.view();
            view.supply = supply;
            view.supply->ofBoundaries = wall == counted;
            const auto text = functions.execute(view, f.time, true, false).at(0);
            return text.substr(text.find("energy"));
        };
        report({}, {{}, 0, 10});
        EXPECT_EQ(report({1, 0, 0}, {{}, 0, 2}), isNamed ? "energy -0.75 beyond their work (dissipated, or taken by walls and openings)"
                                                         : "energy -0.75 beyond their work (dissipated)");
        EXPECT_EQ(report({2, 0, 0}, {{}, 0, 10}),
                  isNamed ? "energy 1 beyond their work (walls and openings)" : "energy 1 beyond their work");
    }
}

/// Units and meanings of the columns that a .dat file says, "[m/s]: velocity", in order.
std::vector<std::string> meaningsIn(const std::string& text)
{
    std::vector<std::string> meanings;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line) && !line.starts_with("# Time");)
        if (line.find(": ") != std::string::npos) meanings.push_back(line.substr(line.find(' ', 2) + 1));
    return meanings;
}
/// The same of all columns that a type is said to write.
std::set<std::string> meaningsOf(const std::string& type)
{
    std::set<std::string> meanings;
    for (const auto& table : functionTables())
        if (table.writer == type)
            for (const auto& column : table.columns) meanings.insert(column.text().substr(column.name.size() + 1));
    return meanings;
}

TEST(BedHydrodynamics, fractionsAndVelocitiesAreThoseByHand)
{
    // A box of height 1 between plates at y = 0.25 and 0.75: porosity 1/2. The lower half of the pore is water (saturation 1/2,
    // hold-up 1/4) and moves at 0.4: superficial 0.1. Each plate has one phase at it: half of the wall is wet.
    Functions f;
    Particles particles(3, {0, 0.25, 0}, {1, 0.75, 1}, 0.0625);
    auto& g = particles.geometry;
    g.low.y = 0;
    g.high.y = 1;
    g.periodic = {true, false, true};
    g.walls.resize(1);
    g.walls[0].name = "plates";
    g.patches = {{std::make_shared<Plane>(Vector<3>{0, 0.25, 0}, Vector<3>{0, 1, 0}), 0},
                 {std::make_shared<Plane>(Vector<3>{0, 0.75, 0}, Vector<3>{0, -1, 0}), 0}};
    particles.phases = {"water", "air"};
    particles.setPhase([](Vector<3> x) { return x.y < 0.5 ? 0 : 1; });
    particles.setU([](Vector<3> x) { return Vector<3>{0, x.y < 0.5 ? -0.4 : 0, 0}; });
    particles.surfaceTension = 0.072;
    particles.g = {0, -9.81, 0};
    f.run(particles, "bed { type bedHydrodynamics; length 0.01; }");
    const auto text = f.folder.read("postProcessing/bed/0/bedHydrodynamics.dat");
    EXPECT_NE(text.find("# Time\tporosity\tsaturation\tholdUp\tsuperficial_water\tinterstitial_water\tsuperficial_air\tinterstitial_air\t"
                        "wettedFraction\tBo\tCa\tRe\tresidenceTime\twettedArea_plates\twettedFraction_plates\n"),
              std::string::npos)
        << text;
    const auto meanings = meaningsIn(text);
    EXPECT_EQ(meanings.size(), 14u) << "of each column";
    for (const auto& meaning : meanings) EXPECT_TRUE(meaningsOf("bedHydrodynamics").contains(meaning)) << meaning;
    const auto row = f.folder.rows("postProcessing/bed/0/bedHydrodynamics.dat").at(0);
    const auto number = [&](std::size_t k) { return std::stod(row.at(k)); };
    EXPECT_NEAR(number(1), 0.5, 1e-12);
    EXPECT_NEAR(number(2), 0.5, 1e-12);
    EXPECT_NEAR(number(3), 0.25, 1e-12);
    EXPECT_NEAR(std::stod(row[4].substr(3)), -0.1, 1e-12) << row[4];
    EXPECT_NEAR(std::stod(row[5].substr(3)), -0.4, 1e-12) << row[5];
    EXPECT_NEAR(number(8), 0.5, 1e-12);
    EXPECT_NEAR(number(9), 1000 * 9.81 * 1e-4 / 0.072, 1e-9);
    EXPECT_NEAR(number(10), 1e-3 * 0.1 / 0.072, 1e-12);
    EXPECT_NEAR(number(11), 1000 * 0.1 * 0.01 / 1e-3, 1e-9);
    EXPECT_NEAR(number(12), 0.25 / 0.1, 1e-12); // all that is in the bed, over what flows through it
    EXPECT_NEAR(number(13), 1, 1e-12);
    EXPECT_NEAR(number(14), 0.5, 1e-12);
    // With the half at x < 1/2 held by an opening, half as much is in the bed, and flows at half the rate.
    for (std::size_t i = 0; i < particles.size(); ++i) particles.heldBy.push_back(particles.x[i] < 0.5);
    f.run(particles, "held { type bedHydrodynamics; length 0.01; }");
    const auto held = f.folder.rows("postProcessing/held/0/bedHydrodynamics.dat").at(0);
    EXPECT_NEAR(std::stod(held.at(3)), 0.125, 1e-12);
    EXPECT_NEAR(std::stod(held.at(4).substr(3)), -0.05, 1e-12) << held[4];
    EXPECT_NEAR(std::stod(held.at(5).substr(3)), -0.4, 1e-12) << held[5];
}

// Two spheres and a floor, all under water: the grains are the spheres unless `grains` names the floor as well; without water between grains of that
// name there is an error that says which are known.
TEST(BedHydrodynamics, countsGrainsAndNotTheSidesThatHoldThem)
{
    Functions f;
    Particles particles(3, {0, 0, 0}, {1, 0.5, 1}, 0.05);
    auto& g = particles.geometry;
    g.high.y = 1;
    g.walls.resize(2);
    g.walls[0].name = "floor";
    g.walls[1].name = "spheres";
    g.patches = {{std::make_shared<Plane>(Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}), 0},
                 {std::make_shared<Sphere>(Vector<3>{0.25, 0.8, 0.5}, 0.15, FluidSide::outside), 1},
                 {std::make_shared<Sphere>(Vector<3>{0.75, 0.25, 0.5}, 0.15, FluidSide::outside), 1}};
    f.run(particles, "bed { type bedHydrodynamics; }\nall { type bedHydrodynamics; grains (floor spheres); }");
    const auto wetted = [&](const std::string& name)
    { return std::stod(f.folder.rows("postProcessing/" + name + "/0/bedHydrodynamics.dat").at(0).at(6)); };
    EXPECT_NEAR(wetted("bed"), 0.5, 0.02);
    const double sphere = 4 * std::numbers::pi * 0.0225;
    EXPECT_NEAR(wetted("all"), (1 + sphere) / (1 + 2 * sphere), 0.02);
    Functions wrong;
    wrong.make(particles, "bed { type bedHydrodynamics; grains (sphere); }");
    EXPECT_NE(wrong.mistakes().find("\"sphere\" is unknown. Did you mean \"spheres\"?"), std::string::npos) << wrong.mistakes();
}

// Plug flow along x, steady from the start: L/U at once and later, however little has left by then. Liquid that stands still has no residence time.
TEST(BedHydrodynamics, residenceTimeOfPlugFlowIsExactEarlyAndLate)
{
    Functions f;
    Particles particles(2, {0, 0, 0}, {2, 1, 0}, 0.05);
    auto functions = f.make(particles, "bed { type bedHydrodynamics; porosity 1; direction (1 0 0); }");
    for (const double time : {0.0, 0.1, 7.0})
    {
        particles.time = time;
        particles.setU([&](Vector<3>) { return Vector<3>{time == 7.0 ? 0 : 0.4, 0, 0}; });
        functions.execute(particles.view(), f.time, true, false);
    }
    const auto rows = f.folder.rows("postProcessing/bed/0/bedHydrodynamics.dat");
    ASSERT_EQ(rows.size(), 3u);
    EXPECT_NEAR(std::stod(rows[0].back()), 5, 1e-12);
    EXPECT_NEAR(std::stod(rows[1].back()), 5, 1e-12);
    EXPECT_EQ(rows[2].back(), "nan");
}

// Water falls at 0.4 in the lower half of x, gas rises at 0.1 in the other: half of each through any section that the hat does not leave the box at.
TEST(BedHydrodynamics, flowThroughSectionsAndResidence)
{
    Functions f;
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.05);
    particles.phases = {"water", "air"};
    particles.setPhase([](Vector<3> x) { return x.x < 0.5 ? 0 : 1; });
    particles.setU([](Vector<3> x) { return Vector<3>{0, x.x < 0.5 ? -0.4 : 0.1, 0}; });
    auto view = particles.view();
    view.numbers = {{"marked(out)", 3}, {"transitTime(out)", 0.25}, {"transitDeviation(out)", 0.02}};
    const std::string bed = "bed { type bedHydrodynamics; porosity 1; sections (0.5 0.31); direction (0 -1 0); drain out; }";
    auto functions = f.make(particles, bed);
    ASSERT_EQ(f.mistakes(), "");
    functions.execute(view, f.time, true, false);
    const auto text = f.folder.read("postProcessing/bed/0/bedHydrodynamics.dat");
    const std::string columns =
        "section1_water\tsection1_air\tsection2_water\tsection2_air\tresidenceTime\tmarkedLeft\ttransitTime\ttransitDeviation\n";
    EXPECT_NE(text.find(columns), std::string::npos) << text;
    const auto row = f.folder.rows("postProcessing/bed/0/bedHydrodynamics.dat").at(0);
    const auto fromEnd = [&](std::size_t k) { return std::stod(row.at(row.size() - k)); };
    EXPECT_NEAR(fromEnd(8), 0.2, 1e-12);
    EXPECT_NEAR(fromEnd(7), -0.05, 1e-12);
    EXPECT_NEAR(fromEnd(6), 0.2, 1e-12);
    EXPECT_NEAR(fromEnd(5), -0.05, 1e-12);
    EXPECT_NEAR(fromEnd(4), 1 / 0.4, 1e-12); // of the water alone: the gas beside it does not count
    EXPECT_EQ(fromEnd(3), 3);
    EXPECT_EQ(fromEnd(2), 0.25);
    EXPECT_EQ(fromEnd(1), 0.02);

    const auto says = [&](const std::string& word)
    {
        try
        {
            functions.execute(view, f.time, true, false);
            ADD_FAILURE() << word;
        }
        catch (const CaseError& e)
        {
            EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
        }
    };
    view.numbers = {{"transitTime(outt)", 0.25}};
    says("drain \"out\" is unknown. Did you mean \"outt\"?");
    view.numbers.clear();
    says("drain needs liquid that an inlet of constant/openings marks");
}

TEST(BedHydrodynamics, porosityOfASphereIsSampled)
{
    // 1 - 4/3 pi 0.4^3 in a unit cube; 64 points per direction leave about 1e-3.
    Functions f;
    Particles particles(3, {0, 0, 0}, {1, 1, 1}, 0.5);
    particles.geometry.walls.resize(1);
    particles.geometry.patches = {{std::make_shared<Sphere>(Vector<3>{0.5, 0.5, 0.5}, 0.4, FluidSide::outside), 0}};
    f.run(particles, "bed { type bedHydrodynamics; }");
    EXPECT_NEAR(std::stod(f.folder.rows("postProcessing/bed/0/bedHydrodynamics.dat").at(0).at(1)), 1 - 4.0 / 3 * std::numbers::pi * 0.064,
                1e-3);
}

TEST(BedHydrodynamics, wettedAreaWithoutGasIsAFractionOfTheWholeWall)
{
    // Water up to the equator of a sphere of radius 0.3 wets half of it, within 2 % at six spacings to the radius (WettedWallsTest.cpp).
    Functions f;
    const Sphere sphere({0.5, 0.5, 0.5}, 0.3, FluidSide::outside);
    const Particles lattice(3, {0, 0, 0}, {1, 0.5, 1}, 0.05);
    Particles particles(3, {0, 0, 0}, {0, 0, 0}, 0.05);
    for (std::size_t i = 0; i < lattice.size(); ++i)
        if (sphere.foot(lattice.position(i)).distance > 0) particles.add(lattice.position(i));
    particles.geometry = lattice.geometry;
    particles.geometry.high.y = 1;
    particles.geometry.walls.resize(1);
    particles.geometry.patches = {{std::make_shared<Sphere>(sphere), 0}};
    f.run(particles, "bed { type bedHydrodynamics; }");
    const auto row = f.folder.rows("postProcessing/bed/0/bedHydrodynamics.dat").at(0);
    EXPECT_NEAR(std::stod(row.at(6)), 0.5, 0.02);
}

/// A sphere that counts how often its foot is asked for.
struct CountedSphere : Sphere
{
    inline static std::atomic<long> feet = 0;
    using Sphere::Sphere;
    Foot foot(const Vector<3>& x) const override
    {
        ++feet;
        return Sphere::foot(x);
    }
};

// 1000 spheres: what the grid of samples and the triangles of the walls ask for is a few feet a place, not one of each sphere, and the table is the same to
// the byte. 13 feet a place are measured; twice as many are allowed.
TEST(BedHydrodynamics, asksForAFewFeetAPlaceOfABedOfAThousandSpheres)
{
    Particles particles(3, {0, 0, 0}, {1, 1, 1}, 0.04);
    particles.phases = {"water", "air"};
    particles.setPhase([](Vector<3> x) { return x.z > 0.6; });
    particles.geometry.walls.resize(1);
    for (int i = 0; i < 1000; ++i)
        particles.geometry.patches.push_back(
            {std::make_shared<CountedSphere>(0.1 * Vector<3>{i % 10 + 0.5, i / 10 % 10 + 0.5, i / 100 + 0.5}, 0.035, FluidSide::outside),
             0});
    const std::string bed = "bed { type bedHydrodynamics; samples 20; region { max (1 1 0.2); } }",
                      table = "postProcessing/bed/0/bedHydrodynamics.dat";
    Functions byLoop, byTree;
    byLoop.run(particles, bed);
    const double places = double(CountedSphere::feet.exchange(0)) / 1000;
    EXPECT_GE(places, 8000);
    particles.geometry.tree = std::make_shared<PatchTree>(particles.geometry.patches);
    byTree.run(particles, bed);
    EXPECT_LT(double(CountedSphere::feet), 26 * places);
    EXPECT_EQ(byTree.folder.read(table), byLoop.folder.read(table));
}

// One NaN among numbers, first and last of the particles in the box: the order of a comparison decides which of the two a plain minimum or maximum
// would lose. Outside of the box it does not count.
TEST(FunctionObjects, showANaN)
{
    for (const std::size_t at : {0u, 199u, 399u})
    {
        Functions f;
        Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.05);
        std::vector<double> phi(particles.size(), 0.5);
        phi[at] = particles.p[at] = particles.ux[at] = std::nan("");
        auto view = particles.view();
        view.fields.push_back({"phi", FieldClass::scalar, {phi.data()}});
        auto functions = f.make(particles, "mean { type volFieldValue; operation volAverage; fields (p); max (1 0.5 0); }\n"
                                           "least { type volFieldValue; operation min; fields (p); max (1 0.5 0); }\n"
                                           "most { type volFieldValue; operation max; fields (p); max (1 0.5 0); }\n"
                                           "cavity { type filling; max (1 0.5 0); }\n"
                                           "bins { type profile; start (0 0 0); end (0 1 0); bins 2; fields (p); }\n"
                                           "sums { type conservation; }\n"
                                           "bed { type bedHydrodynamics; region { min (0 0 0); max (1 0.5 0); } }\n");
        ASSERT_EQ(f.mistakes(), "");
        const auto reports = functions.execute(view, f.time, true, false);
        const bool inBox = at < 200;
        for (const std::size_t k : {0u, 1u, 2u}) EXPECT_EQ(reports.at(k).ends_with(" nan"), inBox) << reports[k];
        EXPECT_EQ(reports.at(3).ends_with(", phi nan .. nan"), inBox) << reports[3];
        EXPECT_EQ(reports.at(3).ends_with(", phi 0.5 .. 0.5"), !inBox) << reports[3];
        const auto filling = f.folder.rows("postProcessing/cavity/0/filling.dat").at(0);
        EXPECT_EQ(filling.at(3), inBox ? "nan" : "0.5");
        EXPECT_EQ(filling.at(4), inBox ? "nan" : "0.5");
        const auto bins = f.folder.rows("postProcessing/bins/0/bins_p.xy");
        EXPECT_EQ(bins.at(0).at(1), inBox ? "nan" : "0");
        EXPECT_EQ(bins.at(1).at(1), inBox ? "0" : "nan");
        EXPECT_EQ(f.folder.rows("postProcessing/sums/0/conservation.dat").at(0).at(2), "(nan 0 0)");
        EXPECT_EQ(f.folder.rows("postProcessing/bed/0/bedHydrodynamics.dat").at(0).at(4), inBox ? "(nan 0 0)" : "(0 0 0)");
    }
}

// 14,400 particles, more than three blocks, whose values range over 16 decades, so that any other order of additions shows in the digits, of which
// all are written.
TEST(FunctionObjects, areTheSameOnAnyNumberOfThreads)
{
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 1.0 / 120);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> exponent(-8, 8), sign(-1, 1);
    for (auto* values : {&particles.ux, &particles.uy, &particles.p, &particles.mass, &particles.volume})
        for (double& q : *values) q = std::copysign(std::pow(10, exponent(random)), sign(random));
    for (auto* values : {&particles.mass, &particles.volume})
        for (double& q : *values) q = std::abs(q);
    particles.phases = {"water", "air"};
    particles.setPhase([](Vector<3> x) { return x.x < 0.6 ? 0 : 1; });
    particles.g = {1, -9.81, 0};
    particles.geometry.walls.resize(1);
    particles.geometry.originals = {{std::make_shared<Plane>(Vector<3>{0, 0.5, 0}, Vector<3>{0, 1, 0}), 0},
                                    {std::make_shared<Sphere>(Vector<3>{0.3, 0.7, 0}, 0.1, FluidSide::outside), 0}};
    repeatPeriodically(particles.geometry, 0.05);
    const auto on = [&](int threads)
    {
        omp_set_num_threads(threads);
        Functions f;
        f.run(particles, "sums { type conservation; angularMomentum yes; }\n"
                         "bed { type bedHydrodynamics; }\n"
                         "bins { type profile; start (0 0 0); end (0 1 0); bins 7; fields (p U); }\n"
                         "mean { type volFieldValue; operation volAverage; fields (p U); }\n"
                         "error { type errors; field p; norm absolute; reference { type expression; value \"1\"; } }\n");
        std::string text;
        for (const char* file : {"sums/0/conservation.dat", "bed/0/bedHydrodynamics.dat", "bins/0/bins_p_U.xy", "mean/0/volFieldValue.dat",
                                 "error/0/errors.dat"})
        {
            EXPECT_FALSE(f.folder.rows(std::string("postProcessing/") + file).empty()) << file;
            text += f.folder.read(std::string("postProcessing/") + file);
        }
        return text;
    };
    const int before = omp_get_max_threads();
    const auto one = on(1);
    EXPECT_EQ(on(4), one);
    omp_set_num_threads(before);
}
