#include "Prepared.hpp"
#include <gtest/gtest.h>
#include <numbers>

using namespace sph;
using namespace sph::test;

// The box as OpenFOAM's surfaceCheck tells of it: the same words and numbers; and what the kernel makes of it.
TEST(MeshReport, tellsWhatSurfaceCheckTells)
{
    const auto p = prepared(box({0, 0, 0}, {1, 1, 0.5}));
    const auto text = meshReport(p.mesh, 0.026, true);
    for (const auto* part :
         {"Triangles    : 12 in 1 region(s)", "Vertices     : 8", "Bounding Box : (0 0 0) (1 1 0.5)", "body                 12",
          "Surface has no illegal triangles.", "Triangle quality (equilateral=1, collapsed=0):", "Edges: min 0.5 m between (",
          "Edges: max 1.414 m", "Surface is closed. All edges connected to two faces.", "Number of unconnected parts : 1",
          "Number of zones (connected area with consistent normal) : 1", "Volume of the solid: 0.5 m3; as read 0.5 m3",
          "Sharp edges (more than 30 degrees): 12 convex, 0 concave", "Sharpest convex edge: the fluid has 270 degrees at (",
          "Sharpest concave edge: none", "Smallest face between sharp edges: 0.7071 m = 27.2 H", "Thinnest wall: 0.5 m = 19.2 H at (",
          "Narrowest gap: none"})
        EXPECT_TRUE(has(text, part)) << part << " in\n" << text;
    EXPECT_FALSE(has(meshReport(p.mesh, 0.026, false), "Triangle quality"));
}

// The fluid within a box has corners of 90 degrees, and no solid is seen through it; a slot between two boxes is a gap of 0.1.
TEST(MeshReport, seesEdgesAndGapsAsTheFluidDoes)
{
    const auto inside = prepared(box(), "fluid inside;");
    const auto text = meshReport(inside.mesh, 0.026, true);
    for (const auto* part : {"Volume of the space for the fluid: 1 m3", "0 convex, 12 concave",
                             "Sharpest concave edge: the fluid has 90 degrees at (", "Thinnest wall: none", "Narrowest gap: 1 m"})
        EXPECT_TRUE(has(text, part)) << part << " in\n" << text;
    const auto slot = prepared(together(box(), box({1.125, 0, 0}, {2, 1, 1})));
    EXPECT_NEAR(slot.mesh.clearances.narrowest.width, 0.125, 1e-12);
    EXPECT_NEAR(slot.mesh.clearances.thinnest.width, 0.875, 1e-12);
}

// A wedge of two facets a side, 0.02 thin at x = 0 and 0.52 at x = 1: 20000 points over its area come near the thin end, centroids alone do not.
TEST(MeshReport, findsTheThinEndOfLargeFacets)
{
    auto m = box();
    for (auto& x : m.points)
        if (x.z > 0) x.z = 0.02 + 0.5 * x.x;
    const auto p = prepared(m);
    EXPECT_NEAR(p.mesh.clearances.thinnest.width, 0.02, 0.003);
    EXPECT_NEAR(p.mesh.clearances.thinnest.at.x, 0, 0.01);
}

// Dihedral angles of a regular tetrahedron: arccos 1/3 within, the rest of 360 degrees for the fluid around it.
TEST(MeshReport, dihedralAngles)
{
    const Mesh m{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
    const double within = std::acos(1.0 / 3) * 180 / std::numbers::pi;
    for (const auto& [side, angle] : {std::pair{"fluid outside;", 360 - within}, {"fluid inside;", within}})
    {
        const auto p = prepared(m, side);
        ASSERT_EQ(p.mesh.edges.size(), 6u);
        for (const auto& e : p.mesh.edges) EXPECT_NEAR(e.angle, angle, 1e-9);
    }
}

// The wall that is written is the wall that was prepared, and its edges are there to be looked at: 18 lines and 12 triangles with their arrays.
TEST(MeshReport, writesTheWall)
{
    auto p = prepared(box());
    EXPECT_EQ(writePrepared(p.scene.folder(), p.mesh),
              (std::vector<std::string>{"constant/wallMeshes/rock", "constant/triSurface/rock.edges.vtp"}));
    const auto again = readWallMesh(p.scene.folder(), "rock", *p.diagnostics);
    EXPECT_EQ(again.points, p.mesh.surface.points);
    EXPECT_EQ(again.triangles, p.mesh.surface.triangles);
    EXPECT_EQ(again.regions, p.mesh.surface.regions);
    const auto vtp = p.scene.read("constant/triSurface/rock.edges.vtp");
    for (const auto* part :
         {"NumberOfPoints=\"8\"", "NumberOfLines=\"18\"", "NumberOfPolys=\"12\"", "Name=\"angle\"", "Name=\"kind\"", "Name=\"region\""})
        EXPECT_TRUE(has(vtp, part)) << part;
}
