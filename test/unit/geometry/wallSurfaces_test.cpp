#include "geometry/wallSurfaces.hpp"
#include "reading.hpp"
#include <gtest/gtest.h>

using namespace sph;
using namespace sph::test;

namespace
{

std::size_t count(const std::string& text, const std::string& part)
{
    std::size_t n = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++n;
    return n;
}

}

// A region per wall by its name, a facet per triangle; the VTP file has as many of each as it announces.
TEST(WallSurfaces, areWrittenWithARegionForEachWall)
{
    const auto [g, errors] =
        read("dimension 3; domain { min (0 0 0); max (1 1 1); }\nwalls { floor { type plane; point (0 0 0); normal (0 1 0); }"
             " ball { type sphere; centre (0.5 0.5 0.5); radius 0.2; fluid outside; } }");
    EXPECT_EQ(errors, "");
    const auto surfaces = wallSurfaces(g, 0.1, 0.1);
    ASSERT_EQ(surfaces.size(), 2u);
    const auto triangles = surfaces[0].triangles.size() + surfaces[1].triangles.size();
    const auto stl = stlText(g, surfaces);
    EXPECT_EQ(count(stl, "\nendfacet\n"), triangles);
    EXPECT_EQ(stl.rfind("solid floor\n", 0), 0u);
    EXPECT_EQ(count(stl, "\nsolid ball\n"), 1u);
    EXPECT_EQ(count(stl, "facet normal 0 1 0\n"), surfaces[0].triangles.size());
    const auto vtp = vtpText(g, surfaces);
    EXPECT_EQ(count(vtp, "NumberOfPolys=\"" + std::to_string(triangles) + "\""), 1u);
    EXPECT_EQ(count(vtp, "Name=\"wall\""), 1u);
}

// The floor ends at the domain extended by the margin; nothing sticks out.
TEST(WallSurfaces, endAtTheMargin)
{
    const auto [g, errors] = read(bcc("1"), 0.2);
    const auto surfaces = wallSurfaces(g, 0.05, 0.1);
    for (const auto& p : surfaces[0].points)
        for (const double c : {p.x, p.y, p.z}) EXPECT_TRUE(c >= -0.05 && c <= 1.05);
}

// A 2-D scene is a slice.
TEST(WallSurfaces, of2DScenesAreSlices)
{
    const auto [g, errors] = read(square + "walls { a { type ellipsoid; centre (0.5 0.5 0); semiAxes (0.3 0.2 0); fluid outside; } }");
    const auto surfaces = wallSurfaces(g, 0.1, 0.1);
    ASSERT_FALSE(surfaces[0].points.empty());
    for (const auto& p : surfaces[0].points) EXPECT_LE(std::abs(p.z), 0.05 + 1e-15);
}
