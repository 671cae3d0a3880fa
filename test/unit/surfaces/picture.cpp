#include "surfaces/Picture.hpp"
#include "base/CaseError.hpp"
#include "particles.hpp"
#include "pixels.hpp"
#include "surfaces/Cuts.hpp"
#include "surfaces/VirtualDisplay.hpp"
#include "temporaryFolder.hpp"
#include <gtest/gtest.h>
#include <sys/wait.h>

namespace sph::test
{

namespace
{

/// The test's environment without a display, put back at its end.
class WithoutDisplay
{
    const char* variable_;
    std::string before_;

public:
    explicit WithoutDisplay(const char* variable = "DISPLAY") : variable_(variable)
    {
        if (const char* value = std::getenv(variable)) before_ = value;
        unsetenv(variable);
    }
    ~WithoutDisplay()
    {
        if (!before_.empty()) setenv(variable_, before_.c_str(), 1);
    }
};

}

// Without DISPLAY a server is started, a picture of a blue ball on a grey floor drawn, and the server ended: no child is left.
// The colours are counted: a blank picture has one only.
TEST(Picture, IsDrawnWithoutDisplay)
{
    if (!isInstalled("Xvfb")) GTEST_SKIP() << "Xvfb is not installed";
    const WithoutDisplay none;
    const TemporaryFolder folder;
    auto geometry = space(3, {-8, 0, -8}, {8, 12, 8});
    const auto grid = gridOfDomain(geometry, step);
    const auto colour = colourFunction(grid, {}, lattice(geometry, ball({0, 6, 0}, 4)), "wendlandC2", support, Normalisation::particles);
    std::vector<double> floor(grid.size());
    for (std::size_t node = 0; node < floor.size(); ++node)
        floor[node] = 1 - (grid.low.y + grid.step.y * double(node / grid.nodes[0] % grid.nodes[1]));
    Scene scene;
    scene.low = geometry.low;
    scene.high = geometry.high;
    scene.liquid = freeSurface(grid, colour, 0.5, geometry, 20);
    scene.wallCuts = cutFaces(grid, floor, {});
    scene.size = {300, 200};
    scene.title = "Time = 1 s";
    {
        const VirtualDisplay display;
        EXPECT_TRUE(display.started());
        ASSERT_NE(std::getenv("DISPLAY"), nullptr);
        EXPECT_GE(std::atoi(std::getenv("DISPLAY") + 1), 10) << "mpirun looks at those below, and ends where one goes";
        drawPicture(scene, folder / "ball.png");
    }
    EXPECT_EQ(std::getenv("DISPLAY"), nullptr);
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "no child process is left";
    const Pixels pixels(folder / "ball.png");
    EXPECT_EQ(pixels.width(), 300);
    EXPECT_EQ(pixels.height(), 200);
    EXPECT_GT(pixels.share(isWhite), 0.3);
    EXPECT_GT(pixels.share(isBlue), 0.02);
    EXPECT_GT(pixels.share(isGrey), 0.03);
}

// A plane scene shows its particles in the colours of their phases.
TEST(Picture, ShowsParticlesOfAPlaneScene)
{
    if (!isInstalled("Xvfb")) GTEST_SKIP() << "Xvfb is not installed";
    const WithoutDisplay none;
    const TemporaryFolder folder;
    const auto geometry = space(2, {-10, -10, 0}, {10, 10, 0});
    const auto particles = lattice(geometry, ball({0, 0, 0}, 8));
    Scene scene;
    scene.dimension = 2;
    scene.low = geometry.low;
    scene.high = geometry.high;
    scene.points.position = particles.position;
    for (const char in : particles.inPhase) scene.points.value.push_back(in ? 0 : 1);
    scene.points.diameter = 1;
    scene.points.phases = {"water", "air"};
    scene.size = {400, 300};
    const VirtualDisplay display;
    drawPicture(scene, folder / "disc.png");
    const double drawn = sqr(300 / 1.12) / (400.0 * 300),
                 disc = drawn * 3.14 * 64 / 400; // parts of the picture: the domain, the water
    EXPECT_NEAR(Pixels(folder / "disc.png").share(isBlue), disc, 0.35 * disc);
}

// Where Xvfb is not to be found the error says what to install.
TEST(Picture, SaysThatXvfbIsMissing)
{
    const WithoutDisplay none, noPath("PATH");
    const TemporaryFolder folder;
    setenv("PATH", folder.path().c_str(), 1);
    try
    {
        const VirtualDisplay display;
        FAIL() << "nothing was thrown";
    }
    catch (const CaseError& error)
    {
        EXPECT_NE(std::string(error.what()).find("Xvfb is not installed (Debian: apt install xvfb)"), std::string::npos) << error.what();
    }
    EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1);
}

}
