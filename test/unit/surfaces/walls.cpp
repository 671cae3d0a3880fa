#include "Largest.hpp"
#include "geometry/Plane.hpp"
#include "geometry/Sphere.hpp"
#include "parallel/reduce.hpp"
#include "particles.hpp"
#include "surfaces/EnclosedVolume.hpp"
#include "surfaces/IsoSurface.hpp"
#include <gtest/gtest.h>
#include <numbers>
#include <vtkFeatureEdges.h>
#include <vtkNew.h>

namespace sph::test
{

namespace
{

using std::numbers::pi;

/// A plane wall at height `height` with fluid above, askew to no grid plane unless `height` is.
Geometry overPlane(double height)
{
    auto g = space(3, {-20, -20, -4}, {20, 20, 20});
    g.walls.resize(1);
    g.patches.push_back({std::make_shared<Plane>(Vector<3>{0, 0, height}, Vector<3>{0, 0, 1}), 0});
    return g;
}

struct Cap
{
    double R = 16;
    Geometry geometry = overPlane(0);
    RegularGrid grid = gridOfDomain(geometry, step);
    std::vector<double> wall = wallDistances(grid, geometry), colour;

    explicit Cap(Normalisation normalise, bool gas = true)
        : colour(colourFunction(grid, wall, lattice(geometry, ball({0, 0, 0}, R), gas), "wendlandC2", support, normalise))
    {}
};

}

// A hemisphere on a plane: free area within 3 % of 2 pi R^2 and volume within 1.5 % of the half ball, with the gas there and with
// the gas left out; the surface meets the wall in a circle of the sphere's radius (0.3 spacings) and nothing of it is in the
// solid.
TEST(Walls, AHemisphereEndsOnThePlane)
{
    for (const bool gas : {true, false})
    {
        SCOPED_TRACE(gas ? "gas" : "no gas");
        const Cap cap(gas ? Normalisation::particles : Normalisation::walls, gas);
        const auto surface = freeSurface(cap.grid, cap.colour, 0.5, cap.geometry, 0);
        EXPECT_NEAR(measure(surface) / (2 * pi * sqr(cap.R)), 1, 0.03);
        EXPECT_NEAR(enclosedVolume(cap.grid, cap.colour, 0.5, cap.wall).volume / (2 * pi / 3 * cube(cap.R)), 1, 0.015);
        double highest = 0, lowest = 1;
        int onWall = 0;
        for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
        {
            double x[3];
            surface->GetPoint(p, x);
            Smaller{}(lowest, x[2]);
            Larger{}(highest, x[2]);
            if (std::fabs(x[2]) > 1e-9) continue;
            ++onWall;
            EXPECT_NEAR(std::hypot(x[0], x[1]), cap.R, 0.6) << "on the contact line";
        }
        EXPECT_GE(lowest, -1e-12);
        EXPECT_NEAR(highest, cap.R, 0.3);
        EXPECT_GT(onWall, 100);
    }
}

// Why there is a normalisation: the plain sum loses half the kernel at the wall, where C deep in the liquid falls to the 1/2 of the
// iso-surface; divided by the sum over all particles it stays 1.
TEST(Walls, ThePlainSumFallsToOneHalfOnTheWall)
{
    const Cap plain(Normalisation::none), divided(Normalisation::particles);
    const auto below = [](const Cap& cap)
    {
        Largest largest; // of C at the wall, deep in the liquid
        for (int k = 0; k < cap.grid.nodes[2]; ++k)
            for (int i = 0; i < cap.grid.nodes[0]; ++i)
                if (const auto x = cap.grid.node(i, 40, k); x.z == 0 && std::fabs(x.x) < 8) largest(cap.colour[cap.grid.index(i, 40, k)]);
        return largest.value();
    };
    EXPECT_NEAR(below(plain), 0.5, 0.05);
    EXPECT_NEAR(below(divided), 1, 1e-12);
}

// Closed along the wall the half ball is watertight, and its volume by the divergence theorem is that of the sum over tetrahedra
// within 0.5 % (its edge is rounded by part of a step).
TEST(Walls, ClosedSurfaceIsWatertight)
{
    const Cap cap(Normalisation::particles);
    const auto closed = closedSurface(cap.grid, cap.colour, 0.5, cap.wall, support);
    vtkNew<vtkFeatureEdges> edges;
    edges->SetInputData(closed);
    edges->FeatureEdgesOff();
    edges->ManifoldEdgesOff();
    edges->Update();
    EXPECT_EQ(edges->GetOutput()->GetNumberOfCells(), 0);
    EXPECT_NEAR(signedVolume(closed) / enclosedVolume(cap.grid, cap.colour, 0.5, cap.wall).volume, 1, 5e-3);
    EXPECT_NEAR(measure(closed) / (3 * pi * sqr(cap.R)), 1, 0.02);
}

// A periodic domain full of liquid has no free surface, and closed it is the domain's own box, exactly.
TEST(Walls, AFullDomainClosesAlongItsFaces)
{
    auto geometry = space(3, {0, 0, 0}, {8, 8, 8});
    geometry.periodic = {true, true, true};
    const auto grid = gridOfDomain(geometry, step);
    const auto colour =
        colourFunction(grid, {}, lattice(geometry, [](Vector<3>) { return true; }), "wendlandC2", support, Normalisation::none);
    EXPECT_EQ(freeSurface(grid, colour, 0.5, geometry, 0)->GetNumberOfCells(), 0);
    EXPECT_NEAR(enclosedVolume(grid, colour, 0.5, {}).volume, 512, 1e-10);
    const auto closed = closedSurface(grid, colour, 0.5, {}, support);
    EXPECT_NEAR(signedVolume(closed), 512, 1);
    EXPECT_NEAR(measure(closed), 6 * 64, 3);
}

// The liquid between two grains is cut by both: a full pore around a sphere in a periodic cube has the volume of the pore. 0.3 %:
// chords of the sphere on a grid of 12 steps a radius.
TEST(Walls, AFullPoreHasThePoresVolume)
{
    auto geometry = space(3, {0, 0, 0}, {16, 16, 16});
    geometry.periodic = {true, true, true};
    geometry.walls.resize(1);
    geometry.originals.push_back({std::make_shared<Sphere>(Vector<3>{8, 8, 8}, 6, FluidSide::outside), 0});
    repeatPeriodically(geometry, support);
    const auto grid = gridOfDomain(geometry, step);
    const auto wall = wallDistances(grid, geometry);
    const auto all = lattice(geometry, [](Vector<3>) { return true; });
    const auto colour = colourFunction(grid, wall, all, "wendlandC2", support, Normalisation::walls);
    const double pore = cube(16) - 4 * pi / 3 * cube(6);
    EXPECT_NEAR(enclosedVolume(grid, colour, 0.5, wall).volume / pore, 1, 3e-3);
    EXPECT_NEAR(measure(freeSurface(grid, colour, 0.5, geometry, 0)), 0, 1e-12) << "no surface but the wall's";
    EXPECT_NEAR(measure(wallSurface(grid, wall, geometry)) / (4 * pi * sqr(6)), 1, 0.01);
}

}
