/// Pictures of a 3-D case by the application: fields on the surface, cuts, translucent walls, all particles.
#include "Largest.hpp"
#include "case/Cloud.hpp"
#include "particles.hpp"
#include "pixels.hpp"
#include "surfaces/Picture.hpp"
#include "surfaces/SmoothedField.hpp"
#include "surfaces/VirtualDisplay.hpp"
#include "temporaryFolder.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <vtkPointData.h>

namespace sph::test
{

namespace
{

/// A ball of water of radius 5 mm, spacing 1 mm, with T = 300 + 1000 x, and a smaller ball of solid before its right half.
class BallCase : public testing::Test
{
protected:
    TemporaryFolder folder;
    std::string output;
    static inline std::unique_ptr<VirtualDisplay> display; ///< one for all pictures: a server takes longer than a picture

    static void SetUpTestSuite()
    {
        if (isInstalled("Xvfb")) display = std::make_unique<VirtualDisplay>();
    }
    static void TearDownTestSuite() { display.reset(); }
    void SetUp() override
    {
        if (!isInstalled("Xvfb")) GTEST_SKIP() << "Xvfb is not installed";
        folder.write("constant/geometry", "dimension 3;\ndomain { min (-0.008 -0.008 -0.008); max (0.008 0.008 0.012); }\n"
                                          "walls { post { type sphere; centre (0.003 0 0.009); radius 2e-3; fluid outside; } }\n");
        folder.write("constant/phaseProperties", "phases (water);\n");
        folder.write("system/sphSchemes", "resolution { spacing 1e-3; support 3; kernel wendlandC2; }\n");
        const auto particles = lattice(space(3, {-8, -8, -8}, {8, 8, 8}), ball({0, 0, 0}, 5), false);
        std::vector<double> x, y, z, T;
        for (const auto& at : particles.position)
        {
            x.push_back(1e-3 * at.x);
            y.push_back(1e-3 * at.y);
            z.push_back(1e-3 * at.z);
            T.push_back(300 + at.x);
        }
        writeCloud(folder / "1", "sph", x.size(), {"positions", FieldClass::vector, {x.data(), y.data(), z.data()}},
                   {{"T", FieldClass::scalar, {T.data()}}}, {});
    }

    /// Exit code of a picture from straight before the ball, with further entries.
    int draw(const std::string& entries)
    {
        folder.write("system/reconstructSurfaceDict",
                     "picture\n{\n    size (240 180); showTime no; camera { position (0 0 0.06); focalPoint (0 0 0); up (0 1 0); }\n" +
                         entries + "\n}\n");
        const auto log = folder / "log";
        const int status = std::system(
            fmt::format("{} -case {} -picture -noSurface > {} 2>&1", RECONSTRUCT_SURFACE, folder.path().string(), log.string()).c_str());
        output = contents(log);
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
    Pixels picture() const { return Pixels(folder / "postProcessing/reconstructSurface/1/water.png"); }
};

/// Left and right of the ball's middle; the legend is beyond.
constexpr double middle = 0.5, legend = 0.88;

}

// The surface has the colours of the field, whose least value is on the left, and the legend both ends.
TEST_F(BallCase, ColoursTheSurfaceByAField)
{
    ASSERT_EQ(draw("    show (surface); colourBy T;"), 0) << output;
    const auto field = picture();
    EXPECT_GT(field.share(isLeast, 0, middle), 0.004);
    EXPECT_EQ(field.share(isLeast, middle, legend), 0);
    EXPECT_GT(field.share(isMost, middle, legend), 0.004);
    EXPECT_EQ(field.share(isMost, 0, middle), 0);
    EXPECT_GT(field.share(isLeast, legend, 1), 0.001);
    EXPECT_GT(field.share(isMost, legend, 1), 0.001);

    // Of a range that begins beyond the field all has the least colour.
    ASSERT_EQ(draw("    show (surface); colourBy T; range (400 500);"), 0) << output;
    EXPECT_EQ(picture().share(isMost, 0, legend), 0);

    EXPECT_EQ(draw("    show (surface);\n    colourBy Temperature;"), 1);
    EXPECT_NE(output.find("system/reconstructSurfaceDict:5: the cloud has no scalar or vector field \"Temperature\". Known fields: T"),
              std::string::npos)
        << output;
}

// A cut across x removes what lies to its right. A scale bar is dark at the lower left.
TEST_F(BallCase, ACutRemovesWhatLiesBeforeIt)
{
    ASSERT_EQ(draw("    show (surface); colourBy T;"), 0) << output;
    EXPECT_GT(picture().share(isMost, middle, legend), 0.004);
    ASSERT_EQ(draw("    show (surface); colourBy T; cut { point (0 0 0); normal (1 0 0); }"), 0) << output;
    EXPECT_EQ(picture().share(isMost, middle, legend), 0);
    EXPECT_GT(picture().share(isLeast, 0, middle), 0.001);
    const auto dark = [](const Pixels::Colour& c) { return c[0] < 60 && c[1] < 60 && c[2] < 70; };
    ASSERT_EQ(draw("    show (walls);"), 0) << output;
    const auto without = picture().share(dark, 0, 0.3);
    ASSERT_EQ(draw("    show (walls); scaleBar yes;"), 0) << output;
    EXPECT_GT(picture().share(dark, 0, 0.3), without + 0.002);
}

// A solid hides the ball behind it, and lets it shine through where it is translucent.
TEST_F(BallCase, TranslucentWallsShowWhatIsBehind)
{
    const auto most = [&](const std::string& shown)
    {
        EXPECT_EQ(draw("    colourBy T; show " + shown), 0) << output;
        return picture().share(isMost, middle, legend);
    };
    const double alone = most("(surface);"), hidden = most("(surface walls);"), through = most("(surface walls); wallOpacity 0.2;");
    EXPECT_LT(hidden, 0.8 * alone);
    EXPECT_GT(through, 1.1 * hidden);
}

// All particles are balls as far as the whole ball reaches to the left and right; those of a plane off its middle are fewer.
TEST_F(BallCase, ShowsAllParticles)
{
    ASSERT_EQ(draw("    show (particles); colourBy T; plane { point (0 0 -4e-3); }"), 0) << output;
    const auto onPlane = 1 - picture().share(isWhite);
    ASSERT_EQ(draw("    show (particles); colourBy T; particles all;"), 0) << output;
    EXPECT_GT(1 - picture().share(isWhite), 1.2 * onPlane);
    EXPECT_GT(picture().share(isLeast, 0, middle), 0.005);
    EXPECT_GT(picture().share(isMost, middle, legend), 0.005);
    ASSERT_EQ(draw("    show (particles); colourBy T; particles all; cut { normal (1 0 0); }"), 0) << output;
    EXPECT_EQ(picture().share(isMost, middle + 0.02, legend), 0);
}

TEST_F(BallCase, MistakesHaveFileAndLine)
{
    const auto message = [&](const std::string& entries)
    {
        EXPECT_EQ(draw(entries), 1) << entries;
        return output;
    };
    const std::string where = "system/reconstructSurfaceDict:4: ";
    EXPECT_NE(
        message("show (surface); colourBy phase;").find(where + "the surface is that of one phase: name a field, or show the particles"),
        std::string::npos)
        << output;
    EXPECT_NE(message("show (particles); cut { }").find(where + "the particles lie on a cut, `plane`, already"), std::string::npos)
        << output;
    EXPECT_NE(message("wallOpacity 2;").find(where + "\"wallOpacity\" must"), std::string::npos) << output;
    EXPECT_NE(message("particles some;").find(where + "particles \"some\" is unknown. Known particles: onPlane, all"), std::string::npos)
        << output;
    folder.write("constant/geometry", "dimension 2;\ndomain { min (-0.008 -0.008 0); max (0.008 0.008 0); }\n");
    EXPECT_NE(message("cut { }").find(where + "a plane scene is not cut"), std::string::npos) << output;
}

// What is linear in space is found exactly between nodes, and beyond the grid the value of its face.
TEST(RegularGrid, InterpolatesLinearly)
{
    for (const int dimension : {2, 3})
    {
        const auto grid = gridOfDomain(space(dimension, {-1, 0, 0}, {2, 1, 3}), 0.25);
        const auto f = [&](const Vector<3>& x) { return 1 + 2 * x.x - 3 * x.y + (dimension == 3 ? 0.5 * x.z : 0); };
        std::vector<double> values(grid.size());
        for (int k = 0; k < grid.nodes[2]; ++k)
            for (int j = 0; j < grid.nodes[1]; ++j)
                for (int i = 0; i < grid.nodes[0]; ++i) values[grid.index(i, j, k)] = f(grid.node(i, j, k));
        for (const Vector<3>& x : {Vector<3>{0.3, 0.6, 1.7}, {-1, 0, 0}, {2, 1, 3}})
            EXPECT_NEAR(interpolated(grid, values, x), f(x), 1e-12);
        EXPECT_NEAR(interpolated(grid, values, {5, 0.5, 1}), f({2, 0.5, 1}), 1e-12);
    }
}

// A constant stays constant on the surface, where half of the kernel is empty; a linear field is met there within a spacing's change. Particles of another
// phase do not count.
TEST(SmoothedField, IsTheFieldOnTheSurface)
{
    const auto geometry = space(3, {-8, -8, -8}, {8, 8, 8});
    const auto grid = gridOfDomain(geometry, step);
    const auto particles = lattice(geometry, ball({0, 0, 0}, 5));
    const auto surface =
        freeSurface(grid, colourFunction(grid, {}, particles, "wendlandC2", support, Normalisation::particles), 0.5, geometry, 0);
    const auto largestError = [&](const auto& f)
    {
        std::vector<double> values;
        for (std::size_t p = 0; p < particles.size(); ++p) values.push_back(particles.inPhase[p] ? f(particles.position[p]) : 1e6);
        SmoothedField(grid, particles, values, "wendlandC2", support).colour(surface);
        Largest error;
        for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
        {
            double x[3];
            surface->GetPoint(p, x);
            error(surface->GetPointData()->GetScalars()->GetComponent(p, 0) - f(Vector<3>{x[0], x[1], x[2]}));
        }
        return error.value();
    };
    EXPECT_LT(largestError([](const Vector<3>&) { return 7.0; }), 1e-12);
    EXPECT_LT(largestError([](const Vector<3>& x) { return 10 + x.x; }), 1.0);
}

TEST(Picture, LengthsOfScaleBarsAreRound)
{
    EXPECT_DOUBLE_EQ(roundLength(0.0049), 0.002);
    EXPECT_DOUBLE_EQ(roundLength(0.0051), 0.005);
    EXPECT_DOUBLE_EQ(roundLength(1.9), 1);
    EXPECT_DOUBLE_EQ(roundLength(23), 20);
}

}
