#include "case/Cloud.hpp"
#include "particles.hpp"
#include "pixels.hpp"
#include "temporaryFolder.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

namespace sph::test
{

namespace
{

/// A 2-D case of a disc of water of radius 8 in air, spacing 1 mm, at times 0, 0.1 and 0.2.
class DiscCase : public testing::Test
{
protected:
    TemporaryFolder folder;
    std::string output;

    void SetUp() override
    {
        folder.write("constant/geometry", "dimension 2;\ndomain { min (-0.012 -0.012 0); max (0.012 0.012 0); periodic (x y); }\n");
        folder.write("constant/phaseProperties", "phases (water air);\n");
        folder.write("system/sphSchemes", "resolution { spacing 1e-3; support 3; kernel wendlandC2; }\n");
        const auto particles = lattice(space(2, {-12, -12, 0}, {12, 12, 0}), ball({0, 0, 0}, 8));
        std::vector<double> x, y, phase, m, rho;
        for (std::size_t p = 0; p < particles.size(); ++p)
        {
            x.push_back(1e-3 * particles.position[p].x);
            y.push_back(1e-3 * particles.position[p].y);
            phase.push_back(particles.inPhase[p] ? 0 : 1);
            rho.push_back(particles.inPhase[p] ? 1000 : 1);
            m.push_back(1e-6 * rho.back());
        }
        for (const auto* time : {"0", "0.1", "0.2"})
            writeCloud(folder / time, "sph", x.size(), {"positions", FieldClass::vector, {x.data(), y.data(), nullptr}},
                       {{"phase", FieldClass::label, {phase.data()}},
                        {"m", FieldClass::scalar, {m.data()}},
                        {"rho", FieldClass::scalar, {rho.data()}}},
                       {});
    }

    int run(const std::string& options)
    {
        const auto log = folder / "log";
        const int status = std::system(
            fmt::format("{} -case {} {} > {} 2>&1", RECONSTRUCT_SURFACE, folder.path().string(), options, log.string()).c_str());
        output = contents(log);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    bool has(const std::string& file) { return std::filesystem::exists(folder.path() / "postProcessing" / "reconstructSurface" / file); }
};

}

// Without a dictionary of its own it writes the surface of the first phase at all times, and a table whose area is the circle's
// length within 2 %.
TEST_F(DiscCase, NeedsNoDictionary)
{
    ASSERT_EQ(run(""), 0) << output;
    for (const auto* time : {"0", "0.1", "0.2"}) EXPECT_TRUE(has(fmt::format("{}/water.vtp", time)));
    EXPECT_FALSE(has("0/air.vtp"));
    std::istringstream table(contents(folder.path() / "postProcessing/reconstructSurface/0/surfaces.dat"));
    std::string line;
    std::getline(table, line);
    std::getline(table, line);
    EXPECT_EQ(line, "# area [m]: area of the surface");
    while (std::getline(table, line) && !line.starts_with("# Time")) {}
    EXPECT_EQ(line, "# Time\tarea\tvolume\tparticleVolume\tdifference%\tpieces");
    double time, length, area, particleArea, difference, pieces;
    for (const double expected : {0.0, 0.1, 0.2})
    {
        ASSERT_TRUE(table >> time >> length >> area >> particleArea >> difference >> pieces);
        EXPECT_EQ(time, expected);
        EXPECT_NEAR(length / (2 * 3.14159e-3 * 8), 1, 0.02);
        EXPECT_NEAR(difference, 100 * (area / particleArea - 1), 1e-9);
        EXPECT_EQ(pieces, 1);
    }
}

// -time takes lists and ranges, -latestTime the last, -phase one phase; what is not there is an error that lists what is.
TEST_F(DiscCase, OptionsSelectTimesAndPhases)
{
    ASSERT_EQ(run("-time 0.1: -phase air"), 0) << output;
    EXPECT_FALSE(has("0/air.vtp"));
    EXPECT_TRUE(has("0.1/air.vtp"));
    EXPECT_TRUE(has("0.2/air.vtp"));
    EXPECT_TRUE(has("0.1/surfaces.dat"));
    ASSERT_EQ(run("-latestTime"), 0) << output;
    EXPECT_TRUE(has("0.2/water.vtp"));
    EXPECT_FALSE(has("0.1/water.vtp"));
    ASSERT_EQ(run("-time 0,0.1"), 0) << output;
    EXPECT_TRUE(has("0/water.vtp"));
    EXPECT_TRUE(has("0.1/water.vtp"));

    EXPECT_EQ(run("-time 0.7"), 1);
    EXPECT_NE(output.find("-time: no time folder matches \"0.7\". There are: 0, 0.1, 0.2"), std::string::npos) << output;
    EXPECT_EQ(run("-time now"), 1);
    EXPECT_NE(output.find("-time: \"now\" is neither a time nor a range"), std::string::npos) << output;
    EXPECT_EQ(run("-phase wasser"), 1);
    EXPECT_NE(output.find("-phase: \"wasser\" is unknown. Did you mean \"water\"?"), std::string::npos) << output;
}

// Mistakes in the case's files end with exit code 1 and their file and line, before anything is written.
TEST_F(DiscCase, MistakesHaveFileAndLine)
{
    folder.write("system/reconstructSurfaceDict", "closed no;\nsmothing 3;\nformats (stl);\n");
    EXPECT_EQ(run(""), 1);
    EXPECT_NE(output.find("system/reconstructSurfaceDict:2: entry \"smothing\" is not used here. Did you mean \"smoothing\"?"),
              std::string::npos)
        << output;
    EXPECT_NE(output.find("system/reconstructSurfaceDict:3: stl holds triangles only"), std::string::npos) << output;
    EXPECT_FALSE(std::filesystem::exists(folder / "postProcessing"));
    std::filesystem::remove(folder / "system/reconstructSurfaceDict");
    std::filesystem::remove(folder / "system/sphSchemes");
    EXPECT_EQ(run(""), 1);
    EXPECT_NE(output.find("system/sphSchemes"), std::string::npos) << output;
}

// -picture -noSurface draws the particles and writes nothing else.
TEST_F(DiscCase, DrawsPictures)
{
    if (!isInstalled("Xvfb")) GTEST_SKIP() << "Xvfb is not installed";
    folder.write("system/reconstructSurfaceDict", "picture { size (320 240); colourBy phase; }\n");
    ASSERT_EQ(run("-latestTime -picture -noSurface"), 0) << output;
    EXPECT_TRUE(has("0.2/water.png"));
    EXPECT_FALSE(has("0.2/water.vtp"));
    EXPECT_FALSE(has("0.2/surfaces.dat"));
    folder.write("system/reconstructSurfaceDict", "picture\n{\n    colourBy p;\n}\n");
    EXPECT_EQ(run("-latestTime -picture"), 1);
    EXPECT_NE(output.find("system/reconstructSurfaceDict:3: the cloud has no scalar or vector field \"p\""), std::string::npos) << output;
}

// A picture shows the walls that it names: without the box around it the same, with another wall not.
TEST_F(DiscCase, ShowsTheWallsThatAreNamed)
{
    if (!isInstalled("Xvfb")) GTEST_SKIP() << "Xvfb is not installed";
    const std::string ball = "post { type sphere; centre (0.004 0.002 0); radius 2e-3; fluid outside; }\n",
                      space = "dimension 2;\ndomain { min (-0.012 -0.012 0); max (0.012 0.012 0); }\n";
    const auto picture = [&](const std::string& walls, const std::string& shown)
    {
        folder.write("constant/geometry", space + "walls\n{\n" + walls + "}\n");
        folder.write("system/reconstructSurfaceDict", "picture\n{\n    size (160 120);\n    show (walls);\n" + shown + "}\n");
        EXPECT_EQ(run("-latestTime -picture -noSurface"), 0) << output;
        return contents(folder.path() / "postProcessing" / "reconstructSurface" / "0.2" / "water.png");
    };
    const std::string slab = "slab { type plane; point (0 -0.006 0); normal (0 1 0); }\n";
    const auto post = picture(ball, "");
    EXPECT_NE(picture(slab + ball, ""), post);
    EXPECT_EQ(picture(slab + ball, "    walls (post);\n"), post);
    folder.write("system/reconstructSurfaceDict", "picture\n{\n    walls (pots);\n}\n");
    EXPECT_EQ(run("-latestTime -picture"), 1);
    EXPECT_NE(output.find("system/reconstructSurfaceDict:3: \"pots\" is unknown. Did you mean \"post\"?"), std::string::npos) << output;
}

// Pictures of all times are joined in their order; no format, no ffmpeg and a single picture are said before anything is drawn.
TEST_F(DiscCase, JoinsPicturesToASequence)
{
    EXPECT_EQ(run("-movie avi"), 1);
    EXPECT_NE(output.find("-movie: \"avi\" is unknown. Known formats: mp4, gif"), std::string::npos) << output;
    const std::string path = std::getenv("PATH");
    setenv("PATH", folder.path().c_str(), 1);
    EXPECT_EQ(run("-movie gif"), 1);
    setenv("PATH", path.c_str(), 1);
    EXPECT_NE(output.find("-movie: ffmpeg is not installed (Debian: apt install ffmpeg)"), std::string::npos) << output;
    EXPECT_FALSE(has("0/water.png"));
    if (!isInstalled("Xvfb") || !isInstalled("ffmpeg")) GTEST_SKIP() << "Xvfb or ffmpeg is not installed";
    EXPECT_EQ(run("-movie gif -latestTime"), 1);
    EXPECT_NE(output.find("-movie: one picture is no sequence"), std::string::npos) << output;
    folder.write("system/reconstructSurfaceDict", "picture { size (161 121); framesPerSecond 5; }\n");
    ASSERT_EQ(run("-movie gif -noSurface"), 0) << output;
    const auto gif = contents(folder / "postProcessing/reconstructSurface/water.gif");
    EXPECT_TRUE(gif.starts_with("GIF89a"));
    // A block of graphic control stands before each picture: 0.2 s, in hundredths.
    std::size_t pictures = 0;
    for (auto at = gif.find("\x21\xf9\x04"); at != gif.npos; at = gif.find("\x21\xf9\x04", at + 1))
    {
        EXPECT_EQ(gif[at + 4], 20);
        ++pictures;
    }
    EXPECT_EQ(pictures, 3u);
    // An odd number of pixels, and a case by a relative path.
    ASSERT_EQ(std::system(fmt::format("cd {} && {} -movie mp4 -noSurface > log 2>&1", folder.path().string(), RECONSTRUCT_SURFACE).c_str()),
              0)
        << contents(folder / "log");
    EXPECT_EQ(contents(folder / "postProcessing/reconstructSurface/water.mp4").substr(4, 4), "ftyp");
    EXPECT_FALSE(has(".water.frames"));
    EXPECT_FALSE(has("log.ffmpeg"));
}

}
