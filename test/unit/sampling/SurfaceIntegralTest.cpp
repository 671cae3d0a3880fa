/// Integrals over walls against those in closed form.
#include "sampling/SurfaceIntegral.hpp"
#include "Particles.hpp"
#include "geometry/PatchTree.hpp"
#include "geometry/Plane.hpp"
#include "geometry/Sphere.hpp"
#include <gtest/gtest.h>
#include <numbers>

using namespace sph;

namespace
{

/// Numbers of the one row that the object writes, vectors by component, without the time.
std::vector<double> integralsOf(const Particles& particles, const std::string& text, std::string* mistakes = nullptr)
{
    TemporaryCase folder;
    const Case theCase(folder.folder());
    const RunTime time(theCase);
    const auto d = Dictionary::parse(text, "system/controlDict", theCase.sharedDiagnostics());
    SurfaceIntegral object(d, FunctionContext{"own", particles.geometry, particles.phases, outputOf(time)});
    d.reportUnused();
    if (mistakes)
    {
        *mistakes = errorsOf(theCase.diagnostics());
        return {};
    }
    EXPECT_EQ(errorsOf(theCase.diagnostics()), "");
    object.execute(particles.view());
    std::vector<double> numbers;
    const auto row = folder.rows("postProcessing/own/0/surfaceIntegral.dat").at(0);
    for (std::size_t k = 1; k < row.size(); ++k)
    {
        auto text2 = row[k];
        for (char& c : text2)
            if (c == '(' || c == ')') c = ' ';
        std::istringstream words(text2);
        for (double value = 0; words >> value;) numbers.push_back(value);
    }
    return numbers;
}

/// Water at rest in the unit square, with walls at the floor and on the right, under p = 1 - y.
Particles basin()
{
    Particles particles(2, {0, 0, 0}, {1, 1, 0}, 0.05);
    auto& g = particles.geometry;
    g.walls.resize(2);
    g.walls[0].name = "floor";
    g.walls[1].name = "right";
    g.patches = {{std::make_shared<Plane>(Vector<3>{0, 0, 0}, Vector<3>{0, 1, 0}), 0},
                 {std::make_shared<Plane>(Vector<3>{1, 0, 0}, Vector<3>{-1, 0, 0}), 1}};
    particles.setP([](Vector<3> x) { return 1 - x.y; });
    return particles;
}

}

// A linear pressure is carried to the walls and integrated exactly, but for the points in the corner: thrust 1/2 at a third of the height. There the kernel's sphere is cut twice, and its part in the
// fluid is counted by a few points: 5e-5 of the whole.
TEST(SurfaceIntegral, ofALinearPressureIsThatByHand)
{
    const auto particles = basin();
    const auto floor = integralsOf(particles, "wall floor; value \"$p\";"), right = integralsOf(particles, "wall right; value \"$p\";");
    const std::vector<double> onFloor{1, 1, 0, -1, 0, 0, 0, -0.5}, onRight{1, 0.5, 0.5, 0, 0, 0, 0, -1 / 6.};
    ASSERT_EQ(floor.size(), 8u);
    ASSERT_EQ(right.size(), 8u);
    for (std::size_t k = 0; k < 8; ++k)
    {
        EXPECT_NEAR(floor[k], onFloor[k], 1e-4) << k;
        EXPECT_NEAR(right[k], onRight[k], 1e-4) << k;
    }
    const auto half = integralsOf(particles, "wall right; value \"$p + 2*$t\"; region { min (0 0 0); max (1 0.5 0); } origin (1 0 0);");
    EXPECT_NEAR(half[0], 0.5, 1e-12);
    EXPECT_NEAR(half[1], 0.375, 1e-4);
    const auto away = integralsOf(particles, "wall right; value \"$p\"; region { min (0 0.3 0); max (1 0.7 0); }");
    EXPECT_NEAR(away[1], 0.2, 1e-12);
    EXPECT_NEAR(away[7], -(0.2 - (0.343 - 0.027) / 3), 1e-12);
}

// Buoyancy of a sphere in a liquid under p = -z: its volume, upwards; of second order in the spacing, 2 % and 0.5 % at 8 and 16 spacings to the radius.
TEST(SurfaceIntegral, ofASphereIsItsBuoyancy)
{
    double before = 0;
    for (const double dx : {0.25 / 4, 0.25 / 8})
    {
        Particles all(3, {-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}, dx), particles(3, {0, 0, 0}, {0, 0, 0}, dx);
        particles.geometry = all.geometry;
        auto& g = particles.geometry;
        g.walls.resize(1);
        g.walls[0].name = "ball";
        g.patches = {{std::make_shared<Sphere>(Vector<3>{0, 0, 0}, 0.25, FluidSide::outside), 0}};
        for (std::size_t i = 0; i < all.size(); ++i)
            if (mag(all.position(i)) > 0.25) particles.add(all.position(i));
        particles.setP([](Vector<3> x) { return 3 - x.z; });
        const auto ball = integralsOf(particles, "wall ball; value \"$p\";");
        const double volume = 4 * std::numbers::pi / 3 * std::pow(0.25, 3), error = std::abs(ball[4] / volume - 1);
        EXPECT_LT(error, before > 0 ? 0.3 * before : 0.05);
        EXPECT_NEAR(ball[2], 0, 1e-3 * volume);
        before = error;
    }
}

TEST(SurfaceIntegral, mistakesNameTheirLine)
{
    std::string mistakes;
    integralsOf(basin(), "wall flor;\nvalue \"sqrt(\";\n", &mistakes);
    EXPECT_EQ(mistakes, "system/controlDict:1: wall \"flor\" is unknown. Did you mean \"floor\"? Known wall: floor, right.\n"
                        "system/controlDict:2: value \"sqrt(\": expected \")\" at the end\n2 errors");
}
