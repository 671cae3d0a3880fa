#include "Prepared.hpp"
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace sph::test::repairTest
{

namespace
{

Mesh without(Mesh m, const auto& facet)
{
    Mesh less{m.points, {}};
    for (std::size_t f = 0; f < m.triangles.size(); ++f)
        if (!facet(centroid(m, int(f)))) less.triangles.push_back(m.triangles[f]);
    return less;
}

constexpr double ballVolume = 4 * std::numbers::pi / 3;

}

// The corners of the facets of an STL are points again; a whole mesh needs nothing else.
TEST(Repair, weldsAlone)
{
    const auto p = prepared(box());
    EXPECT_EQ(p.repairs, "36 points welded to 8: those within 1.73e-06 m of each other\n");
    EXPECT_EQ(Prepared("rock.off", off(box())).repairs, "");
}

// Points 1e-4 apart are one only where `weld` says so; the needle that is left of its facet goes and is listed.
TEST(Repair, weldsWithinTheTolerance)
{
    auto m = box();
    m.points.push_back({1e-4, 0, 0});
    m.triangles[4] = {8, 1, 5};
    m.triangles.push_back({0, 8, 5});
    EXPECT_TRUE(has(prepared(m).errors, "the surface is open"));
    const auto p = prepared(m, "weld 1e-3;");
    EXPECT_EQ(p.errors, "");
    EXPECT_TRUE(has(p.repairs, "39 points welded to 8: those within 0.001 m of each other\n1 facet with two corners in one point removed"))
        << p.repairs;
    EXPECT_DOUBLE_EQ(p.mesh.prepared.volume, 1);
}

// Facets that are there twice, and a wall between two boxes that touch.
TEST(Repair, removesDuplicates)
{
    auto m = box();
    m.triangles.push_back(m.triangles[5]);
    EXPECT_TRUE(has(prepared(m).repairs, "1 facet that another one covers removed"));

    auto right = box({1, 0, 0}, {2, 1, 1});
    right.triangles[8] = {0, 4, 2}; // with the diagonal of the other's face
    right.triangles[9] = {4, 6, 2};
    auto left = box();
    left.triangles[10] = {1, 3, 5};
    left.triangles[11] = {3, 7, 5};
    const auto two = prepared(together(left, right));
    EXPECT_EQ(two.errors, "");
    EXPECT_TRUE(has(two.repairs, "4 facets that lie back to back removed")) << two.repairs;
    EXPECT_DOUBLE_EQ(two.mesh.prepared.volume, 2);
}

// Three of twelve facets turned the wrong way are turned back; then a whole shell that is inside out, and one with the fluid inside.
TEST(Repair, orients)
{
    auto m = box();
    for (const std::size_t f : {1u, 5u, 6u}) std::swap(m.triangles[f][0], m.triangles[f][1]);
    const auto mixed = prepared(m);
    EXPECT_TRUE(has(mixed.repairs, "3 facets turned, so that neighbours agree")) << mixed.repairs;
    EXPECT_GT(mixed.mesh.asRead.zones, 1);
    EXPECT_EQ(mixed.mesh.prepared.zones, 1);
    EXPECT_DOUBLE_EQ(mixed.mesh.prepared.volume, 1);

    const auto outside = prepared(inverted(box()));
    EXPECT_TRUE(has(outside.repairs, "1 of 1 closed surface turned (12 facets), so that normals point into the fluid")) << outside.repairs;
    EXPECT_DOUBLE_EQ(outside.mesh.prepared.volume, 1);
    EXPECT_DOUBLE_EQ(prepared(box(), "fluid inside;").mesh.prepared.volume, -1);
    EXPECT_FALSE(has(prepared(inverted(box()), "fluid inside;").repairs, "turned"));
}

// A box within a box within a box, and one beside them: the solid of 1 m, its cavity, a core in the cavity; normals by nesting.
TEST(Repair, alternatesNestedShells)
{
    const auto m = together(together(together(box({0.4, 0.4, 0.4}, {0.6, 0.6, 0.6}), box()), box({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8})),
                            box({-1, 0, 0}, {-0.5, 0.5, 0.5}));
    const double solidVolume = 1 - 0.216 + 0.008 + 0.125;
    const auto p = prepared(m);
    ASSERT_EQ(p.errors, "");
    EXPECT_NEAR(p.mesh.prepared.volume, solidVolume, 1e-6);
    EXPECT_TRUE(has(p.repairs, "1 of 4 closed surfaces turned (12 facets)")) << p.repairs;
    EXPECT_TRUE(has(p.repairs, "2 of 4 closed surfaces lie in another one")) << p.repairs;
    EXPECT_NEAR(prepared(m, "fluid inside;").mesh.prepared.volume, -solidVolume, 1e-6);
}

// Two boxes that have one corner in common: the point is split, and neither box is changed.
TEST(Repair, splitsPointsWherePartsTouch)
{
    const auto p = prepared(together(box(), box({1, 1, 1}, {2, 2, 2})));
    ASSERT_EQ(p.errors, "");
    EXPECT_TRUE(has(p.repairs, "1 point in which parts touch split")) << p.repairs;
    EXPECT_EQ(p.mesh.surface.points.size(), 16u);
    EXPECT_DOUBLE_EQ(p.mesh.prepared.volume, 2);
}

// A point in the middle of an edge belongs to the one side as a facet without area: it is closed, and the flip leaves no such facet.
TEST(Repair, removesCaps)
{
    auto m = box();
    m.points.push_back({0.5, 0, 0});
    m.triangles[1] = {0, 3, 8};
    m.triangles.push_back({8, 3, 1});
    m.triangles.push_back({0, 8, 1}); // collinear, beside facet 4
    const auto p = prepared(m, "rotation { axis (1 2 3); angle 20; }");
    ASSERT_EQ(p.errors, "");
    EXPECT_LT(p.mesh.asRead.leastQuality, 1e-6);
    EXPECT_TRUE(has(p.repairs, "1 facet lower than 2.3e-06 m removed by a flip of the longest edge")) << p.repairs;
    EXPECT_GT(p.mesh.prepared.leastQuality, 0.3);
    EXPECT_NEAR(p.mesh.prepared.volume, 1, 1e-12);
}

// A sphere without its pole is open; closed on request, it has the volume of the mesh less the cap, and a hole wider than allowed stays an error.
TEST(Repair, closesHolesOnRequest)
{
    const auto m = without(icosphere(4), [](const Vector<3>& x) { return x.z > 0.9; });
    EXPECT_TRUE(has(prepared(m).errors, "the surface is open"));
    EXPECT_TRUE(has(prepared(m, "closeHoles 0.5;").errors, "the surface is open"));
    const auto p = prepared(m, "closeHoles 1.5;");
    ASSERT_EQ(p.errors, "");
    EXPECT_TRUE(has(p.repairs, "1 hole closed with ")) << p.repairs;
    const double cap = std::numbers::pi * 0.01 * (3 - 0.1) / 3; // pi h^2 (3 R - h)/3
    EXPECT_NEAR(p.mesh.prepared.volume, ballVolume - cap, 0.02);
    EXPECT_EQ(p.mesh.prepared.open, 0u);
}

// Two boxes that overlap in a corner of 0.5 x 0.6 x 0.7 become one: its volume is that of the union, its regions are those of the two.
TEST(Repair, unitesBodiesThatCross)
{
    const auto a = box(), b = box({0.5, 0.4, 0.3}, {1.5, 1.4, 1.3});
    const Prepared p("rock.stl", solid(a, "a") + solid(b, "b"), "removeSelfIntersections yes;");
    ASSERT_EQ(p.errors, "");
    EXPECT_TRUE(has(p.repairs, "2 closed surfaces that cross or touch in ")) << p.repairs;
    EXPECT_TRUE(has(p.repairs, "united to 1")) << p.repairs;
    EXPECT_NEAR(p.mesh.prepared.volume, 2 - 0.5 * 0.6 * 0.7, 1e-6);
    double areaOfA = 0;
    for (std::size_t f = 0; f < p.mesh.surface.triangles.size(); ++f)
        if (p.mesh.surface.region[f] == 0) areaOfA += 0.5 * mag(areaVector(p.mesh.surface, int(f)));
    EXPECT_NEAR(areaOfA, 6 - 0.5 * 0.6 - 0.6 * 0.7 - 0.7 * 0.5, 1e-6);
    EXPECT_EQ(prepared(a, "removeSelfIntersections yes;").repairs, prepared(a).repairs);
}

// Where round bodies cross, their union has edges of any shortness: none is left below the tolerance of welding. The
// volume is less by that of the lenses in which the spheres cross, pi (2R - d)^2 (d^2 + 4 d R)/(12 d), somewhat smaller between facets.
TEST(Repair, leavesNoNeedlesWhereBodiesCross)
{
    auto bed = icosphere(3, 0.5);
    for (const Vector<3>& x : {Vector<3>{0.98, 0, 0}, {0.49, 0.85, 0.02}, {0.5, 0.28, 0.79}}) append(bed, icosphere(3, 0.5, x));
    const auto p = prepared(bed, "removeSelfIntersections yes; weld 1e-4;");
    const double lenses = 3.573e-3;
    ASSERT_EQ(p.errors, "");
    EXPECT_TRUE(has(p.repairs, "4 closed surfaces that cross or touch in ")) << p.repairs;
    EXPECT_GE(p.mesh.prepared.shortest.length, 1e-4);
    EXPECT_NEAR(p.mesh.prepared.volume, p.mesh.asRead.volume - lenses, 0.3 * lenses);
}

// A scan: a sphere of radius 1 with noise of 0.01 in each point, three holes of 0.2 m, and facets that cross others. Its wrap is closed, and
// nowhere further from the sphere than the noise (sqrt 3 x 0.01), the offset (half the tolerance) and the sagitta of its facets, alpha^2/8.
TEST(Repair, wrapsAScan)
{
    auto m = without(icosphere(5), [](const Vector<3>& x) { return x.x > 0.995 || x.y > 0.995 || x.z < -0.995; });
    std::mt19937 random(1);
    std::uniform_real_distribution<double> noise(-0.01, 0.01);
    for (auto& x : m.points) x += Vector<3>{noise(random), noise(random), noise(random)};
    for (std::size_t f = 0; f < 200; f += 10) std::swap(m.triangles[f][0], m.triangles[f][1]);
    EXPECT_FALSE(prepared(m).mesh.usable);
    const double tolerance = 0.02, alpha = 0.25;
    const auto p = prepared(m, fmt::format("wrap {{ tolerance {}; alpha {}; }}", tolerance, alpha));
    ASSERT_EQ(p.errors, "");
    EXPECT_TRUE(has(p.repairs, "wrapped with")) << p.repairs;
    EXPECT_TRUE(has(p.repairs, "the wrap is at most ")) << p.repairs;
    EXPECT_TRUE(has(p.repairs, "the mesh is at most ")) << p.repairs;
    EXPECT_EQ(p.mesh.prepared.parts, 1);
    for (const auto& x : p.mesh.surface.points) EXPECT_NEAR(mag(x), 1, 0.01 * std::sqrt(3.0) + tolerance / 2 + alpha * alpha / 8);
    EXPECT_NEAR(p.mesh.prepared.volume / ballVolume, 1, 3 * (0.01 + tolerance / 2));
    EXPECT_TRUE(has(prepared(m, "wrap { tolerance 0.01; } closeHoles 1;").errors, "a wrap leaves no holes"));
}

// Remeshing keeps the box exactly, with its regions and edges; of a sphere it loses no more volume than the sagitta of the new facets takes
// away: 3 (e/R)^2/8 with edges e of up to 4/3 of those asked for.
TEST(Repair, remeshesToTheEdgeLength)
{
    const auto m = box();
    const Prepared flat("rock.stl", solid(m, "lid", 0, 2) + solid(m, "shell", 2), "edgeLength 0.1;");
    ASSERT_EQ(flat.errors, "");
    EXPECT_TRUE(has(flat.repairs, "12 facets remeshed to ")) << flat.repairs;
    EXPECT_NEAR(flat.mesh.prepared.volume, 1, 1e-9);
    EXPECT_LT(flat.mesh.prepared.longest.length, 0.2);
    EXPECT_GT(flat.mesh.prepared.triangles, 1000u);
    double lid = 0;
    for (std::size_t f = 0; f < flat.mesh.surface.triangles.size(); ++f)
        if (flat.mesh.surface.region[f] == 0) lid += 0.5 * mag(areaVector(flat.mesh.surface, int(f)));
    EXPECT_NEAR(lid, 1, 1e-9);

    const double edge = 0.2;
    const auto round = prepared(icosphere(4), fmt::format("edgeLength {};", edge));
    ASSERT_EQ(round.errors, "");
    EXPECT_NEAR(round.mesh.prepared.volume / ballVolume, 1, 3 * sqr(4 * edge / 3) / 8);
    EXPECT_LT(round.mesh.prepared.triangles, 3000u);
}

}
