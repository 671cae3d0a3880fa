#include "particles.hpp"
#include "surfaces/EnclosedVolume.hpp"
#include "surfaces/IsoSurface.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test
{

using std::numbers::pi;

// A disc of 16 spacings' radius in 2-D: contour length within 1.5 % of the circle (radii 12 to 20 give 0.05 to 1.3 %, as the
// lattice's staircase falls), area within 0.5 % of the particles' (measured 0.15 to 0.45 %, the curvature's bias), joined to one
// line that ends where it begins.
TEST(Circle, LengthAndArea)
{
    const double R = 16;
    const auto geometry = space(2, {-20, -20, 0}, {20, 20, 0});
    const auto grid = gridOfDomain(geometry, step);
    EXPECT_EQ(grid.nodes[2], 1);
    const auto particles = lattice(geometry, ball({0, 0, 0}, R));
    for (const auto normalise : {Normalisation::none, Normalisation::walls, Normalisation::particles})
    {
        const auto colour = colourFunction(grid, {}, particles, "wendlandC2", support, normalise);
        const auto contour = freeSurface(grid, colour, 0.5, geometry, 0);
        EXPECT_NEAR(measure(contour) / (2 * pi * R), 1, 0.015);
        EXPECT_NEAR(enclosedVolume(grid, colour, 0.5, {}).volume / particles.phaseVolume(), 1, 0.005);
        ASSERT_EQ(contour->GetNumberOfLines(), 1);
        auto* line = contour->GetCell(0);
        EXPECT_EQ(line->GetPointId(0), line->GetPointId(line->GetNumberOfPoints() - 1));
    }
}

// A disc cut in halves by a domain face: the free surface is half a circle, and `closed` adds the diameter along the face.
TEST(Circle, IsClosedAlongTheFaceOfTheDomain)
{
    const double R = 16;
    const auto geometry = space(2, {-20, 0, 0}, {20, 20, 0});
    const auto grid = gridOfDomain(geometry, step);
    const auto colour = colourFunction(grid, {}, lattice(geometry, ball({0, 0, 0}, R)), "wendlandC2", support, Normalisation::walls);
    EXPECT_NEAR(measure(freeSurface(grid, colour, 0.5, geometry, 0)) / (pi * R), 1, 0.015);
    const auto closed = closedSurface(grid, colour, 0.5, {}, support);
    EXPECT_NEAR(measure(closed) / (pi * R + 2 * R), 1, 0.015);
    double bounds[6];
    closed->GetBounds(bounds);
    EXPECT_EQ(bounds[2], 0) << "the cap lies on the face exactly";
}

}
