#include "particles.hpp"
#include "surfaces/EnclosedVolume.hpp"
#include "surfaces/IsoSurface.hpp"
#include <gtest/gtest.h>
#include <numbers>
#include <vtkFeatureEdges.h>
#include <vtkMassProperties.h>
#include <vtkNew.h>
#include <vtkPointData.h>

namespace sph::test
{

namespace
{

using std::numbers::pi;

struct Ball
{
    double R;
    Geometry geometry;
    RegularGrid grid;
    PhaseParticles particles;
    std::vector<double> colour;

    explicit Ball(double radius, Normalisation normalise = Normalisation::particles, double spacing = step)
        : R(radius),
          geometry(space(3, {-R - 4, -R - 4, -R - 4}, {R + 4, R + 4, R + 4})),
          grid(gridOfDomain(geometry, spacing)),
          particles(lattice(geometry, ball({0, 0, 0}, R))),
          colour(colourFunction(grid, {}, particles, "wendlandC2", support, normalise))
    {}
};

int edges(vtkPolyData* mesh)
{
    vtkNew<vtkFeatureEdges> filter;
    filter->SetInputData(mesh);
    filter->FeatureEdgesOff();
    filter->ManifoldEdgesOff();
    filter->Update();
    return int(filter->GetOutput()->GetNumberOfCells());
}

}

// A ball of 16 spacings' radius: volume within 1 % and area within 2 % of the sphere. Expected: displacement inwards by 2H s^2/2
// makes the volume 0.8 % smaller than the particles', which are themselves 0.6 % more than the sphere.
TEST(Sphere, VolumeAndArea)
{
    const Ball b(16);
    const auto enclosed = enclosedVolume(b.grid, b.colour, 0.5, {});
    EXPECT_NEAR(enclosed.volume / (4 * pi / 3 * cube(b.R)), 1, 0.01);
    EXPECT_EQ(enclosed.pieces, 1);
    const auto surface = freeSurface(b.grid, b.colour, 0.5, b.geometry, 0);
    EXPECT_NEAR(measure(surface) / (4 * pi * sqr(b.R)), 1, 0.02);
    EXPECT_NEAR(measure(freeSurface(b.grid, b.colour, 0.5, b.geometry, 20)) / (4 * pi * sqr(b.R)), 1, 0.005);
}

// The bias of the enclosed volume against the particles' is the curvature's, s^2/R^2 times a constant: of second order in
// spacing/R. Radii 8 and 16 give the order 2; 1.7 leaves room for the lattice's own staircase.
TEST(Sphere, BiasOfTheVolumeIsOfSecondOrder)
{
    const auto bias = [](double R)
    {
        const Ball b(R);
        return enclosedVolume(b.grid, b.colour, 0.5, {}).volume / b.particles.phaseVolume() - 1;
    };
    const double coarse = bias(8), fine = bias(16);
    EXPECT_LT(coarse, 0);
    EXPECT_GT(std::log2(coarse / fine), 1.7);
    EXPECT_LT(std::log2(coarse / fine), 2.3);
}

// Inside a uniform lattice, and inside any lattice when divided by the sum over all particles, the colour function is 1: of the
// plain sum to the kernel's own quadrature error, here below 1 %; of the quotient to round-off. Far away it is 0.
// The level that encloses a given volume does, on a small ball that the surface of half colour makes too small by a tenth.
TEST(EnclosedVolume, FollowsTheLevelAskedFor)
{
    const Ball b(4);
    const double volume = b.particles.phaseVolume();
    const auto enclosed = [&](double level) { return enclosedVolume(b.grid, b.colour, level, {}).volume; };
    EXPECT_LT(enclosed(0.5), 0.95 * volume);
    const double level = levelEnclosing(volume, enclosed);
    EXPECT_LT(level, 0.5);
    EXPECT_NEAR(enclosed(level), volume, 1e-3 * volume);
    EXPECT_NEAR(levelEnclosing(1e9, enclosed), 0.01, 1e-4);
    EXPECT_NEAR(levelEnclosing(0, enclosed), 0.99, 1e-4);
}

TEST(Sphere, ColourFunctionIsOneInsideAndZeroOutside)
{
    for (const auto normalise : {Normalisation::none, Normalisation::particles})
    {
        const Ball b(8, normalise);
        const int middle = b.grid.nodes[0] / 2;
        EXPECT_NEAR(b.colour[b.grid.index(middle, middle, middle)], 1, normalise == Normalisation::none ? 0.01 : 1e-14);
        EXPECT_EQ(b.colour[b.grid.index(0, 0, 0)], 0);
    }
}

// The surface of a ball away from faces is closed, oriented outwards (its volume by the divergence theorem is positive) with
// normals that point away from the centre, within 15 degrees on a lattice's staircase. VTK's own measure of its volume agrees
// with the sum over tetrahedra to the difference of two inscribed polyhedra, 0.1 %.
TEST(Sphere, IsClosedAndOrientedOutwards)
{
    const Ball b(10);
    const auto surface = freeSurface(b.grid, b.colour, 0.5, b.geometry, 0);
    EXPECT_EQ(edges(surface), 0);
    const double volume = signedVolume(surface);
    EXPECT_NEAR(volume / enclosedVolume(b.grid, b.colour, 0.5, {}).volume, 1, 1e-3);
    vtkNew<vtkMassProperties> properties;
    properties->SetInputData(surface);
    properties->Update();
    EXPECT_NEAR(properties->GetVolume() / volume, 1, 1e-3);
    EXPECT_NEAR(properties->GetSurfaceArea() / measure(surface), 1, 1e-6);
    auto* normals = surface->GetPointData()->GetNormals();
    ASSERT_TRUE(normals);
    for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
    {
        double x[3], n[3];
        surface->GetPoint(p, x);
        normals->GetTuple(p, n);
        const Vector<3> at{x[0], x[1], x[2]}, normal{n[0], n[1], n[2]};
        ASSERT_GT(dot(at / mag(at), normal), std::cos(15 * pi / 180)) << "at point " << p;
    }
}

// The sum over tetrahedra is exact for linear functions: half spaces cut a box into known volumes, at walls askew to the surface
// too.
TEST(EnclosedVolume, IsExactForPlanes)
{
    const auto geometry = space(3, {0, 0, 0}, {4, 5, 6});
    const auto grid = gridOfDomain(geometry, 0.7);
    std::vector<double> colour(grid.size()), wall(grid.size());
    for (int k = 0; k < grid.nodes[2]; ++k)
        for (int j = 0; j < grid.nodes[1]; ++j)
            for (int i = 0; i < grid.nodes[0]; ++i)
            {
                const auto x = grid.node(i, j, k);
                colour[grid.index(i, j, k)] = 0.5 + 3.1 - x.x;
                wall[grid.index(i, j, k)] = x.x + 2 * x.y - 3.3;
            }
    EXPECT_NEAR(enclosedVolume(grid, colour, 0.5, {}).volume, 3.1 * 5 * 6, 1e-10);
    // The section in the plane of x and y: the rectangle 3.1 x 5 less the trapezium below y = (3.3 - x)/2.
    EXPECT_NEAR(enclosedVolume(grid, colour, 0.5, wall).volume, 6 * (3.1 * 5 - 3.1 * (3.3 + 0.2) / 4), 1e-10);
}

// Two balls are two pieces; an empty phase has no volume, no surface and no piece.
TEST(EnclosedVolume, CountsPieces)
{
    const auto geometry = space(3, {-10, -6, -6}, {10, 6, 6});
    const auto grid = gridOfDomain(geometry, step);
    const auto two = [](Vector<3> x) { return mag(x - Vector<3>{-5, 0, 0}) < 3 || mag(x - Vector<3>{5, 0, 0}) < 3; };
    const auto colour = colourFunction(grid, {}, lattice(geometry, two), "wendlandC2", support, Normalisation::particles);
    EXPECT_EQ(enclosedVolume(grid, colour, 0.5, {}).pieces, 2);

    const auto none =
        colourFunction(grid, {}, lattice(geometry, [](Vector<3>) { return false; }), "wendlandC2", support, Normalisation::particles);
    EXPECT_EQ(enclosedVolume(grid, none, 0.5, {}).volume, 0);
    EXPECT_EQ(enclosedVolume(grid, none, 0.5, {}).pieces, 0);
    EXPECT_EQ(freeSurface(grid, none, 0.5, geometry, 20)->GetNumberOfCells(), 0);
    EXPECT_EQ(colourFunction(grid, {}, {}, "wendlandC2", support, Normalisation::none), none) << "no particle at all";
}

}
