/// Meshes that the periodic faces of the domain, (-2 -2 -2) to (2 2 2), cut.
#include "Prepared.hpp"
#include "meshes/orientShells.hpp"
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test::periodicTest
{

namespace
{

constexpr std::array<bool, 3> alongX{true, false, false}, everywhere{true, true, true};

/// Without the facets that lie in the plane x = `at`.
Mesh openAt(const Mesh& m, double at)
{
    Mesh open{m.points, {}};
    for (const auto& t : m.triangles)
        if (!std::ranges::all_of(t, [&](int p) { return m.points[std::size_t(p)].x == at; })) open.triangles.push_back(t);
    return open;
}
/// The halves of a box of volume 1 around the face x = 2, that behind it in the place that periodicity gives it, moved by `offset` along y.
std::pair<Mesh, Mesh> halves(double offset = 0) { return {box({1.5, 0, 0}, {2, 1, 1}), box({-2, offset, 0}, {-1.5, 1 + offset, 1})}; }
/// A tube of n sides along x through the domain, open at its ends.
Mesh tube(double radius, int n)
{
    Mesh m;
    for (int k = 0; k < n; ++k)
        for (const double x : {-2.0, 2.0})
        {
            const double angle = 2 * std::numbers::pi * k / n;
            m.points.push_back({x, radius * std::cos(angle), radius * std::sin(angle)});
        }
    for (int k = 0; k < n; ++k)
    {
        const int a = 2 * k, b = 2 * ((k + 1) % n);
        m.triangles.push_back({a, b, b + 1});
        m.triangles.push_back({a, b + 1, a + 1});
    }
    return m;
}
Prepared preparedPeriodically(const Mesh& m, const std::array<bool, 3>& periodic, const std::string& entries = "")
{
    return {"rock.off", off(m), entries, periodic};
}

}

// Open halves and halves with lids make the one body, in the period that its middle lies in.
TEST(PeriodicMesh, BodiesThatAFaceCutsAreWhole)
{
    const auto [left, right] = halves();
    for (const auto& m : {together(openAt(left, 2), openAt(right, -2)), together(left, right)})
    {
        const auto p = preparedPeriodically(m, alongX);
        EXPECT_EQ(p.errors, "");
        EXPECT_EQ(p.repairs, "joined where the periodic faces of x cut it, in 4 edges that match within 0 m: 1 closed surface\n");
        EXPECT_NEAR(p.mesh.prepared.volume, 1, 1e-12);
        EXPECT_EQ(findShells(NumberedMesh{p.mesh.surface, {}, 0}).count, 1);
        EXPECT_EQ(boundingBox(p.mesh.surface).low.x, -2.5);
        EXPECT_EQ(boundingBox(p.mesh.surface).high.x, -1.5);
    }
}

// A box around the corner of a domain that is periodic in all directions comes in eight pieces; another one lies in the middle, with a cavity.
TEST(PeriodicMesh, BodiesThatThreeFacesCutAreWhole)
{
    Mesh m = together(box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}), inverted(box({-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1})));
    for (const double x : {-2.0, 1.75})
        for (const double y : {-2.0, 1.75})
            for (const double z : {-2.0, 1.75}) m = together(m, box({x, y, z}, {x + 0.25, y + 0.25, z + 0.25}));
    const auto p = preparedPeriodically(m, everywhere);
    EXPECT_EQ(p.errors, "");
    EXPECT_NEAR(p.mesh.prepared.volume, 1 - 0.008 + 0.125, 1e-12);
    EXPECT_EQ(findShells(NumberedMesh{p.mesh.surface, {}, 0}).count, 3);
}

// A tube with fluid within goes on through the domain, by a period to either side, and is closed beyond; so does one with a wall of its own, whose ends do not cross.
TEST(PeriodicMesh, WhatGoesOnThroughSpansTheDomain)
{
    const auto pipe = preparedPeriodically(tube(1, 24), alongX, "fluid inside;");
    EXPECT_EQ(pipe.errors, "");
    EXPECT_TRUE(has(
        pipe.repairs,
        "joined where the periodic faces of x cut it, in 24 edges that match within 0 m: one goes on through the domain and is closed beyond it"))
        << pipe.repairs;
    const double area = 12 * std::sin(2 * std::numbers::pi / 24);
    EXPECT_NEAR(pipe.mesh.prepared.volume, -20 * area, 1e-9); // three periods, and one of tube to either side
    EXPECT_NEAR(boundingBox(pipe.mesh.surface).low.x, -10, 1e-12);

    const auto thick = preparedPeriodically(together(tube(1, 24), tube(0.5, 24)), alongX);
    EXPECT_EQ(thick.errors, "");
    EXPECT_NEAR(thick.mesh.prepared.volume, (20 - 0.25 * 16) * area, 1e-9); // the inner one is closed half a period before the outer one
}

// Cuts that do not match are refused with the largest misfit, and joined where `weld` allows for it.
TEST(PeriodicMesh, CutsThatDoNotMatchAreRefused)
{
    const auto [left, right] = halves(0.01);
    const auto m = together(openAt(left, 2), openAt(right, -2));
    const auto p = preparedPeriodically(m, alongX);
    EXPECT_TRUE(has(
        p.errors,
        "the mesh is cut at the periodic faces x = 2 m and x = -2 m, and the cuts do not match: 4 points of the first have no point of the other within"))
        << p.errors;
    EXPECT_TRUE(has(p.errors, "is 0.01 m from the nearest")) << p.errors;
    EXPECT_EQ(preparedPeriodically(m, alongX, "weld 0.02;").errors, "");
}

// What lies at one face alone is no cut; what goes on in two directions cannot be closed.
TEST(PeriodicMesh, WhatIsNoCutStays)
{
    const auto resting = preparedPeriodically(box({1.5, 0, 0}, {2, 1, 1}), alongX);
    EXPECT_EQ(resting.repairs, "");
    EXPECT_NEAR(resting.mesh.prepared.volume, 0.5, 1e-12);
    const auto slab = preparedPeriodically(box({-2, -2, 0}, {2, 2, 1}), everywhere);
    EXPECT_TRUE(has(slab.errors, "one part of the mesh goes on through the periodic faces of x and y")) << slab.errors;
    EXPECT_TRUE(has(preparedPeriodically(openAt(box({1.5, 0, 0}, {2, 1, 1}), 2), alongX).errors, "the surface is open"));
}

}
