#include "declaredEntries.hpp"
#include "particles.hpp"
#include "surfaces/PhaseCloud.hpp"
#include "surfaces/SurfaceSettings.hpp"
#include "surfaces/entries/surfaceEntries.hpp"
#include <gtest/gtest.h>

namespace sph::test
{

namespace
{

std::string errorsOf(const std::string& text, int dimension = 3)
{
    auto diagnostics = std::make_shared<Diagnostics>();
    const auto dict = Dictionary::parse(text, "system/reconstructSurfaceDict", diagnostics);
    readSurfaceSettings(dict, {1e-3, {"water", "air"}, {0, 1, 0}}, space(dimension, {0, 0, 0}, {0.1, 0.1, 0.1}));
    dict.reportUnused();
    try
    {
        diagnostics->throwIfAny();
    }
    catch (const CaseError& error)
    {
        return error.what();
    }
    return "";
}

}

TEST(SurfaceSettings, WhatIsReadIsDeclared)
{
    EXPECT_EQ(difference("system/reconstructSurfaceDict", surfaceEntries(), [](const std::string& text) { errorsOf(text); }), "");
}

// Every entry has a default that follows from the case: half a spacing, a support of three, the first phase, the surface and
// walls in 3-D.
TEST(SurfaceSettings, DefaultsFollowFromTheCase)
{
    auto diagnostics = std::make_shared<Diagnostics>();
    const auto none = Dictionary::empty("system/reconstructSurfaceDict", diagnostics);
    const auto geometry = space(3, {0, 0, 0}, {0.1, 0.2, 0.1});
    const auto s = readSurfaceSettings(none, {1e-3, {"water", "air"}, {0, 0, 1}}, geometry);
    EXPECT_TRUE(diagnostics->ok());
    EXPECT_DOUBLE_EQ(s.gridSpacing, 5e-4);
    EXPECT_DOUBLE_EQ(s.support, 3e-3);
    EXPECT_EQ(s.kernel, "wendlandC2");
    EXPECT_EQ(s.iso, 0.5);
    EXPECT_EQ(s.phases, std::vector<int>{0});
    EXPECT_EQ(s.formats, std::vector<std::string>{"vtp"});
    EXPECT_FALSE(s.closed);
    EXPECT_FALSE(s.normalise.has_value());
    EXPECT_TRUE(s.picture.surface);
    EXPECT_TRUE(s.picture.walls);
    EXPECT_FALSE(s.picture.particles);
    EXPECT_EQ(s.picture.camera.up.z, 1);
    EXPECT_EQ(s.picture.plane.point, (Vector<3>{0.05, 0.1, 0.05}));
    EXPECT_EQ(s.picture.plane.normal, (Vector<3>{0, -1, 0})); // z is up: not along gravity
    const auto single = readSurfaceSettings(none, {1e-3, {"melt"}, {0, 1, 0}}, geometry);
    EXPECT_FALSE(single.picture.surface);
    EXPECT_TRUE(single.picture.particles);
    EXPECT_EQ(single.picture.plane.normal, (Vector<3>{0, 0, 1}));
}

// All entries of the header's example are read.
TEST(SurfaceSettings, ReadsEveryEntry)
{
    auto diagnostics = std::make_shared<Diagnostics>();
    const auto dict = Dictionary::parse(R"(
cloud sph2; phases (air water); gridSpacing 2e-3; support 5e-3; kernel quinticSpline; iso 0.4; normalise none; closed yes;
smoothing 3; formats (stl obj);
picture
{
    size (640 480);
    camera { position (1 2 3); focalPoint (0 0 1); up (0 0 2); zoom 1.5; }
    show (particles); colourBy rho; range (990 1010); plane { point (0 0 0.1); normal (0 2 0); } smoothing 0; title "Bo = 0.78"; showTime no;
})",
                                        "d", diagnostics);
    const auto s = readSurfaceSettings(dict, {1e-3, {"water", "air"}, {0, 1, 0}}, space(3, {0, 0, 0}, {0.1, 0.1, 0.1}));
    dict.reportUnused();
    EXPECT_NO_THROW(diagnostics->throwIfAny());
    EXPECT_EQ(s.cloud, "sph2");
    EXPECT_EQ(s.phases, (std::vector<int>{1, 0}));
    EXPECT_EQ(s.kernel, "quinticSpline");
    EXPECT_EQ(s.normalise, Normalisation::none);
    EXPECT_TRUE(s.closed);
    EXPECT_EQ(s.smoothing, 3);
    EXPECT_EQ(s.formats, (std::vector<std::string>{"stl", "obj"}));
    EXPECT_EQ(s.picture.size, (std::array<int, 2>{640, 480}));
    EXPECT_EQ(s.picture.camera.position, (Vector<3>{1, 2, 3}));
    EXPECT_EQ(s.picture.plane.normal, (Vector<3>{0, 1, 0}));
    EXPECT_FALSE(s.picture.surface);
    EXPECT_EQ(s.picture.colourBy, "rho");
    EXPECT_EQ(s.picture.range, (std::array{990.0, 1010.0}));
    EXPECT_FALSE(s.picture.showTime);
}

// Every mistake is reported with its file and line, and what is possible.
TEST(SurfaceSettings, MistakesHaveFileAndLine)
{
    EXPECT_NE(errorsOf("\nphases (watre);")
                  .find("system/reconstructSurfaceDict:2: \"watre\" is unknown. Did you mean \"water\"? Known phases: water, air."),
              std::string::npos)
        << errorsOf("\nphases (watre);");
    EXPECT_NE(errorsOf("formats (vtk);").find("system/reconstructSurfaceDict:1: \"vtk\" is unknown. Did you mean \"vtp\"?"),
              std::string::npos);
    EXPECT_NE(errorsOf("\n\ngridSpacing 1e-7;").find(":3: gives a grid of 1.0e+18 nodes"), std::string::npos)
        << errorsOf("\n\ngridSpacing 1e-7;");
    EXPECT_NE(errorsOf("support 1e-5;").find("must not be less than gridSpacing"), std::string::npos);
    EXPECT_NE(errorsOf("iso 1;").find(":1: must lie between 0 and 1"), std::string::npos);
    EXPECT_NE(errorsOf("picture\n{\n size (0 900);\n}").find(":3: must be width and height"), std::string::npos);
    EXPECT_NE(errorsOf("picture\n{\n camera { up (0 0 0); }\n}").find(":3: must have a direction"), std::string::npos);
    EXPECT_NE(errorsOf("picture\n{\n range (1 0);\n}").find(":3: must be the least and the largest value"), std::string::npos);
    EXPECT_NE(errorsOf("formats (stl);", 2).find(":1: stl holds triangles only"), std::string::npos);
    EXPECT_NE(errorsOf("picture\n{\n colorBy U;\n}").find(":3: entry \"colorBy\" is not used here. Did you mean \"colourBy\"?"),
              std::string::npos)
        << errorsOf("picture\n{\n colorBy U;\n}");
    EXPECT_EQ(errorsOf(""), "");
}

// Volumes are m/rho where the cloud has a mass, else the given one; phases are told by their number.
TEST(PhaseCloud, VolumesAndPhases)
{
    Cloud cloud;
    cloud.x = {1, 2};
    cloud.y = cloud.z = {0, 0};
    EXPECT_EQ(phaseParticles(cloud, 0, 1, 0.25).phaseVolume(), 0.5);
    cloud.fields["phase"] = {FieldClass::label, {{0, 1}}};
    EXPECT_EQ(phaseParticles(cloud, 1, 2, 0.25).phaseVolume(), 0.25);
    cloud.fields["m"] = {FieldClass::scalar, {{2, 6}}};
    cloud.fields["rho"] = {FieldClass::scalar, {{1, 2}}};
    const auto particles = phaseParticles(cloud, 1, 2, 0.25);
    EXPECT_EQ(particles.phaseVolume(), 3);
    EXPECT_TRUE(particles.hasOtherPhase());
    EXPECT_EQ(particles.position[1], (Vector<3>{2, 0, 0}));
}

// A density that is not positive, a phase that is none and a mass without density are told with file and particle.
TEST(PhaseCloud, ImpossibleValuesAreErrors)
{
    const auto message = [](const Cloud& cloud)
    {
        try
        {
            phaseParticles(cloud, 0, 2, 1);
        }
        catch (const CaseError& error)
        {
            return std::string(error.what());
        }
        return std::string();
    };
    Cloud cloud;
    cloud.folder = "0.1/lagrangian/sph";
    cloud.x = cloud.y = cloud.z = {1, 2};
    cloud.fields["m"] = {FieldClass::scalar, {{1, 1}}};
    EXPECT_EQ(message(cloud), "0.1/lagrangian/sph/rho: is missing: volumes are m/rho");
    cloud.fields["rho"] = {FieldClass::scalar, {{1, 0}}};
    EXPECT_EQ(message(cloud), "0.1/lagrangian/sph/rho: particle 1 at (2 2 2) has rho 0, which must be positive");
    cloud.fields["phase"] = {FieldClass::label, {{2, 1}}};
    EXPECT_EQ(message(cloud),
              "0.1/lagrangian/sph/phase: particle 0 at (1 1 1) has phase 2, but constant/phaseProperties lists 2 phases, 0 to 1");
}

// Vectors are coloured by their magnitude, and an unknown field is an error that lists those there are.
TEST(PhaseCloud, ColouringValues)
{
    Cloud cloud;
    cloud.x = cloud.y = cloud.z = {1};
    cloud.fields["U"] = {FieldClass::vector, {{2}, {3}, {6}}};
    cloud.fields["rho"] = {FieldClass::scalar, {{5}}};
    Diagnostics diagnostics;
    EXPECT_EQ(colouringValues(cloud, "U", {}, diagnostics), std::vector<double>{7});
    EXPECT_EQ(colouringValues(cloud, "rho", {}, diagnostics), std::vector<double>{5});
    EXPECT_TRUE(diagnostics.ok());
    colouringValues(cloud, "u", {"system/reconstructSurfaceDict", 7}, diagnostics);
    try
    {
        diagnostics.throwIfAny();
        FAIL();
    }
    catch (const CaseError& error)
    {
        EXPECT_EQ(std::string(error.what()), "system/reconstructSurfaceDict:7: the cloud has no scalar or vector field \"u\". "
                                             "Did you mean \"U\"? Known fields: U, rho.");
    }
}

}
