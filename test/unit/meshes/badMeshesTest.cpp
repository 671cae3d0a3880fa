#include "Prepared.hpp"
#include <gtest/gtest.h>

namespace sph::test::badMeshesTest
{

namespace
{

/// The error names the entry `file` of constant/geometry, says what is given, and a picture shows it.
void expectError(const Prepared& p, const std::vector<std::string>& parts, bool shown = true)
{
    EXPECT_FALSE(p.mesh.usable);
    EXPECT_TRUE(has(p.errors, "constant/geometry:4: constant/triSurface/rock.stl: ")) << p.errors;
    for (const auto& part : parts) EXPECT_TRUE(has(p.errors, part)) << part << " in " << p.errors;
    EXPECT_EQ(p.showsDefects(), shown);
    EXPECT_EQ(has(p.errors, "constant/triSurface/rock.defects.vtp"), shown);
}

Mesh without(Mesh m, std::size_t facet)
{
    m.triangles.erase(m.triangles.begin() + std::ptrdiff_t(facet));
    return m;
}

}

// Facet 3 is missing, so that three edges have one facet: they are named with coordinates, and what would close the hole.
TEST(BadMesh, open)
{
    expectError(prepared(without(box(), 3)), {"the surface is open: 3 edges of one facet only, around 1 hole, the widest 1.414 m across",
                                              "(0 0 1) (1 1 1) of facet 2 (region body) at (0 0 1) (1 0 1) (1 1 1)", "closeHoles 1.4"});
}

// Three facets at the edge between (0 0 0) and (1 0 0).
TEST(BadMesh, nonManifold)
{
    auto m = box();
    m.points.push_back({0.5, -0.5, -0.5});
    m.triangles.push_back({0, 1, 8});
    expectError(prepared(m), {"the surface is not manifold: more than two facets meet in an edge",
                              "(0 0 0) (1 0 0) of facet 1 (region body)", "facet 12 (region body)"});
}

// A corner of one box within the other: the facets that cross are named.
TEST(BadMesh, selfIntersecting)
{
    expectError(prepared(together(box(), box({0.5, 0.4, 0.3}, {1.5, 1.4, 1.3}))),
                {"the surface crosses or touches itself: ", "facet ", "removeSelfIntersections yes"});
}

// Each facet has its opposite; a tetrahedron whose points lie in a plane.
TEST(BadMesh, withoutVolume)
{
    const Mesh plate{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 1}}};
    expectError(prepared(plate), {"the surface has no volume, each facet has its opposite"}, false);
    const Mesh flat{{{0, 0, 0}, {1, 0, 0}, {0.4, 1, 0}, {0.5, 0.3, 0}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    expectError(prepared(flat, "removeSelfIntersections yes;"), {"the surface has no volume, each facet has its opposite"}, false);
    expectError(prepared(flat), {"1 of 1 closed surface without volume", "facet 0 (region body) at (0 0 0) (0.4 1 0) (1 0 0)"});
}

// A Moebius strip, which also is open: no orientation of its facets makes neighbours agree.
TEST(BadMesh, oneSided)
{
    Mesh m;
    const int n = 12;
    for (int i = 0; i < n; ++i)
    {
        const double a = 2 * 3.141592653589793 * i / n;
        for (const double s : {-0.3, 0.3})
            m.points.push_back({(1 + s * std::cos(a / 2)) * std::cos(a), (1 + s * std::cos(a / 2)) * std::sin(a), s * std::sin(a / 2)});
        const int p = 2 * i, q = p + 1, r = i + 1 < n ? p + 2 : 1, t = i + 1 < n ? p + 3 : 0;
        m.triangles.insert(m.triangles.end(), {{p, r, q}, {q, r, t}});
    }
    expectError(prepared(m), {"the surface has one side only, as a Moebius strip"});
}

TEST(BadMesh, notANumber)
{
    auto text = solid(box());
    text.replace(text.find("vertex 1 1 0"), 12, "vertex 1 nan 0");
    expectError(Prepared("rock.stl", text), {"line 6: the coordinate \"nan\" is no finite number"}, false);
}

// mm for m, and m for mm: the entry scale is named, and what it should be. The domain is 4 m, the spacing 0.01 m.
TEST(BadMesh, wrongUnit)
{
    const auto large = prepared(box({0, 0, 0}, {1000, 1000, 500}), "\n  scale 1;").errors;
    EXPECT_TRUE(has(large, "constant/geometry:7: constant/triSurface/rock.stl: the mesh is 1000 m long, 250 x the domain")) << large;
    EXPECT_TRUE(has(large, "Are its lengths mm? Then scale 0.001;")) << large;
    const auto small = prepared(box({0, 0, 0}, {1e-3, 1e-3, 5e-4})).errors;
    EXPECT_TRUE(has(small, "the mesh is 0.001 m long, less than a spacing, 0.01 m")) << small;
    EXPECT_TRUE(has(small, "scale 1e+03;")) << small;
}

TEST(BadMesh, outsideTheDomain)
{
    const auto errors = prepared(box({3, 0, 0}, {4, 1, 1})).errors;
    EXPECT_TRUE(has(errors, "the mesh, (3 0 0) to (4 1 1), lies outside the domain, (-2 -2 -2) to (2 2 2)")) << errors;
}

// A plate of 0.04 m, thinner than two supports of 0.026 m, is told of with its place; one of 0.06 m is not.
TEST(BadMesh, thinnerThanTwoSupports)
{
    const auto thin = prepared(box({0, 0, 0}, {1, 1, 0.04}));
    EXPECT_EQ(thin.errors, "");
    EXPECT_TRUE(has(thin.warnings, "constant/geometry:4: wall \"rock\" is 0.04 m thin at (")) << thin.warnings;
    EXPECT_EQ(prepared(box({0, 0, 0}, {1, 1, 0.06})).warnings, "");
}

// Single precision 10 km from the origin has points within 0.5 mm only, where the spacing is 10 mm: it is told of by the entry, and what
// to do. Text has the digits.
TEST(BadMesh, farFromTheOrigin)
{
    const auto far = box({10000, 0, 0}, {10001, 1, 1});
    const Prepared p("rock.stl", binaryStl(far), "translation (-10000 0 0);");
    EXPECT_EQ(p.errors, "");
    EXPECT_TRUE(
        has(p.warnings,
            "constant/geometry:4: the coordinates of constant/triSurface/rock.stl are up to 1e+04 and in single precision, seven digits, "
            "within 0.00049 m: write the file in double precision"))
        << p.warnings;
    EXPECT_EQ(Prepared("rock.stl", solid(far), "translation (-10000 0 0);").warnings, "");
}

// What an earlier run has shown is gone with the mistake.
TEST(BadMesh, leavesNoOldPicture)
{
    auto p = prepared(without(box(), 3));
    ASSERT_TRUE(p.showsDefects());
    p.scene.write("constant/triSurface/rock.stl", solid(box()));
    Diagnostics none;
    EXPECT_TRUE(
        prepareMesh(p.scene.folder(), p.mesh.source, {.low = {-2, -2, -2}, .high = {2, 2, 2}, .spacing = 0.01, .H = 0.026}, none).usable);
    EXPECT_FALSE(p.showsDefects());
}

}
