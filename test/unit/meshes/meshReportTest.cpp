#include "Prepared.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test::meshReportTest
{

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
          "Narrowest gap: none", "Hollows tighter than H: none"})
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

// An L whose inner corner is rounded by so many facets of an arc (H = 0.026).
Mesh roundedL(double radius, int facets)
{
    std::vector<Vector<3>> outline{{0, 0, 0}, {1, 0, 0}, {1, 0.25, 0}};
    for (int k = 0; k <= facets; ++k)
    {
        const double a = std::numbers::pi * (1.5 - 0.5 * k / facets);
        outline.push_back({0.25 + radius * (1 + std::cos(a)), 0.25 + radius * (1 + std::sin(a)), 0});
    }
    outline.insert(outline.end(), {{0.25, 1, 0}, {0, 1, 0}});
    return prism(outline, 0, 1);
}

// What is rounded below the support is told with its radius and place, to the seven digits of a file. A hollow wider than the support, the same curve
// around the solid, and an edge that is sharp are none. Middles of edges of a polyhedron lie within its sphere, by 0.5 %.
TEST(MeshReport, tellsOfHollowsBelowTheSupport)
{
    for (const double radius : {0.005, 0.02})
    {
        const auto p = prepared(roundedL(radius, 6));
        EXPECT_EQ(p.mesh.hollows.count, 1u);
        EXPECT_NEAR(p.mesh.hollows.radius, radius, 1e-4 * radius);
        EXPECT_NEAR(mag(p.mesh.hollows.at - Vector<3>{0.25 + radius, 0.25 + radius, p.mesh.hollows.at.z}), radius, 1e-4 * radius);
        const auto there = fmt::format("{:.3g} m at {}, {}", p.mesh.hollows.radius, inWords(p.mesh.hollows.at), p.mesh.hollows.facet);
        EXPECT_TRUE(has(p.mesh.hollows.facet, "facet "));
        EXPECT_TRUE(
            has(p.warnings, "wall \"rock\" has 1 hollow tighter than the support of the kernel, 0.026 m, which cannot resolve it: the "
                            "tightest has a radius of " +
                                there))
            << p.warnings;
        EXPECT_TRUE(has(meshReport(p.mesh, 0.026, true), "Hollows tighter than H: 1, the tightest of radius "));
    }
    for (const auto& p : {prepared(roundedL(0.03, 6)), prepared(roundedL(0.02, 6), "fluid inside;"), prepared(roundedL(0.02, 2))})
    {
        EXPECT_FALSE(has(p.warnings, "hollow")) << p.warnings;
        EXPECT_TRUE(has(meshReport(p.mesh, 0.026, true), "Hollows tighter than H: none"));
    }
    const auto bubble = prepared(icosphere(3, 0.02), "fluid inside;");
    EXPECT_EQ(bubble.mesh.hollows.count, 1u);
    EXPECT_NEAR(bubble.mesh.hollows.radius, 0.02, 0.0002);
    EXPECT_EQ(prepared(icosphere(3, 0.03), "fluid inside;").mesh.hollows.count, 0u);
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

// A block with a groove of that angle along its top, 0.3 m deep: warned of below 20 degrees, by wall, angle and the middle of the groove's edge; the
// places are those of the file to its digits.
TEST(MeshReport, warnsOfGroovesThatDoNotFill)
{
    const auto grooved = [](double angle)
    {
        const double depth = 0.3, half = depth * std::tan(0.5 * angle * std::numbers::pi / 180);
        return prepared(
            prism({{0.5, 0.2, 0}, {0.5 - half, 0.5, 0}, {0, 0.5, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0.5, 0}, {0.5 + half, 0.5, 0}}, 0, 1));
    };
    for (const double angle : {25., 20.5})
    {
        const auto p = grooved(angle);
        EXPECT_EQ(p.errors, "");
        EXPECT_FALSE(has(p.warnings, "groove")) << p.warnings;
    }
    for (const double angle : {19., 15., 5.})
    {
        const auto p = grooved(angle);
        EXPECT_EQ(p.errors, "");
        EXPECT_TRUE(has(p.warnings, "wall \"rock\" has 1 groove of less than 20 degrees")) << p.warnings;
        EXPECT_TRUE(has(p.warnings, fmt::format("The narrowest leaves {:.3g} degrees to the fluid, at (0.5 0.2 0.5)", angle)))
            << p.warnings;
        EXPECT_TRUE(has(meshReport(p.mesh, 0.026, true), "Grooves of less than 20 degrees: 1"));
    }
}

}
