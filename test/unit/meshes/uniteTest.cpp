#include "Prepared.hpp"
#include "meshes/repairSurface.hpp"
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace sph::test::uniteTest
{

namespace
{

/// Euler angles of no simple value: rounding keeps no two faces in one plane.
Mesh turned(Mesh m)
{
    const double a = 0.7, b = 1.1, c = 0.3;
    for (auto& x : m.points)
    {
        x = {std::cos(a) * x.x - std::sin(a) * x.y, std::sin(a) * x.x + std::cos(a) * x.y, x.z};
        x = {x.x, std::cos(b) * x.y - std::sin(b) * x.z, std::sin(b) * x.y + std::cos(b) * x.z};
        x = {std::cos(c) * x.x + std::sin(c) * x.z, x.y, -std::sin(c) * x.x + std::cos(c) * x.z};
    }
    return m;
}

/// A closed tube along a path: rings of points, one for each of its places, and caps about their middles.
Mesh tube(const std::vector<std::vector<Vector<3>>>& rings)
{
    Mesh m;
    const int n = int(rings.size()), k = int(rings[0].size());
    std::vector<Vector<3>> middles;
    for (const auto& ring : rings)
    {
        Vector<3> middle;
        for (const auto& x : ring)
        {
            m.points.push_back(x);
            middle += x / double(k);
        }
        middles.push_back(middle);
    }
    for (int i = 0; i + 1 < n; ++i)
        for (int j = 0; j < k; ++j)
        {
            const int a = i * k + j, b = i * k + (j + 1) % k;
            m.triangles.insert(m.triangles.end(), {{a, b, a + k}, {b, b + k, a + k}});
        }
    const int first = int(m.points.size());
    m.points.push_back(middles.front());
    m.points.push_back(middles.back());
    for (int j = 0; j < k; ++j)
    {
        m.triangles.push_back({first, (j + 1) % k, j});
        m.triangles.push_back({first + 1, (n - 1) * k + j, (n - 1) * k + (j + 1) % k});
    }
    return m;
}

/// Two turns of radius 1 of a tube of radius 0.2, with a pitch of 0.35: its turns lie in one another.
Mesh coil()
{
    const int n = 100, k = 12;
    std::vector<std::vector<Vector<3>>> rings;
    for (int i = 0; i <= n; ++i)
    {
        const double a = 4 * std::numbers::pi * i / n, rise = 0.7 / (4 * std::numbers::pi), l = std::hypot(1, rise);
        const Vector<3> centre{std::cos(a), std::sin(a), 0.7 * i / n}, u{std::cos(a), std::sin(a), 0},
            t{-std::sin(a) / l, std::cos(a) / l, rise / l}, w = cross(t, u);
        std::vector<Vector<3>> ring;
        for (int j = 0; j < k; ++j)
        {
            const double b = 2 * std::numbers::pi * j / k;
            ring.push_back(centre + 0.2 * (std::cos(b) * u + std::sin(b) * w));
        }
        rings.push_back(ring);
    }
    return tube(rings);
}

struct Enclosed
{
    double volume, error;
};

/// Points at random in the box of which the sum of the facets' solid angles (van Oosterom & Strackee 1983, IEEE Trans. Biomed. Eng. 30) is not 0,
/// and the standard error: nothing that the suite measures by.
Enclosed bySolidAngles(const Mesh& m, int samples)
{
    const auto box = boundingBox(m);
    const auto size = box.high - box.low;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> u(0, 1);
    int inside = 0;
    for (int i = 0; i < samples; ++i)
    {
        const Vector<3> x{box.low.x + u(random) * size.x, box.low.y + u(random) * size.y, box.low.z + u(random) * size.z};
        double angle = 0;
        for (const auto& t : m.triangles)
        {
            const auto a = m.points[std::size_t(t[0])] - x, b = m.points[std::size_t(t[1])] - x, c = m.points[std::size_t(t[2])] - x;
            const double la = mag(a), lb = mag(b), lc = mag(c);
            angle += 2 * std::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
        }
        inside += std::lround(angle / (4 * std::numbers::pi)) != 0;
    }
    const double V = size.x * size.y * size.z, p = double(inside) / samples;
    return {V * p, V * std::sqrt(p * (1 - p) / samples)};
}

void expectSameBox(const Prepared& p, const Mesh& m)
{
    const auto was = boundingBox(m), is = p.mesh.prepared.box;
    EXPECT_LT(mag(was.low - is.low) + mag(was.high - is.high), 2e-6 * mag(was.high - was.low));
}

struct Case
{
    const char* name;
    Mesh mesh;
    double volume;
    int surfaces;
};

/// Bodies that share faces, parts of them, edges and corners, with and without common diagonals.
std::vector<Case> contacts()
{
    Mesh stack = box();
    for (int k = 1; k < 5; ++k)
    {
        auto next = box({0, 0, 0.2 * k}, {0.2, 0.2, 0.2 * (k + 1)});
        if (k == 1) stack = box({0, 0, 0}, {0.2, 0.2, 0.2});
        append(stack, k % 2 ? otherDiagonals(next) : next);
    }
    return {{"a small block on a large one", together(box({0, 0, 0}, {1, 1, 0.5}), box({0.25, 0.25, 0.5}, {0.75, 0.75, 1})), 0.625, 1},
            {"the same face", together(box({0, 0, 0}, {0.5, 0.5, 0.5}), box({0.5, 0, 0}, {1, 0.5, 0.5})), 0.25, 1},
            {"the same face, other diagonals", together(box({0, 0, 0}, {0.5, 0.5, 0.5}), otherDiagonals(box({0.5, 0, 0}, {1, 0.5, 0.5}))),
             0.25, 1},
            {"a stack of five", stack, 5 * 0.008, 1},
            {"faces beside one another", together(box({0, 0, 0}, {1, 0.5, 0.5}), box({0.3, 0.2, 0.5}, {1.3, 0.9, 1})), 0.25 + 0.35, 1},
            {"bars across", together(box({-1, -0.2, 0}, {1, 0.2, 0.2}), box({-0.2, -1, 0.2}, {0.2, 1, 0.4})), 2 * 0.16, 1},
            {"a block into a corner of three",
             together(together(box({0, 0, 0}, {1, 1, 0.2}), box({0, 0, 0.2}, {0.2, 1, 1})), box({0.2, 0, 0.2}, {1, 0.2, 1})),
             0.2 + 0.16 + 0.128, 1},
            {"coplanar sides, overlapping", together(box({0, 0, 0}, {1, 0.5, 0.5}), box({0.6, 0, 0}, {1.4, 0.5, 0.5})), 0.35, 1},
            {"one twice", together(box(), otherDiagonals(box())), 1, 1},
            {"an edge", together(box({0, 0, 0}, {0.5, 0.5, 0.5}), box({0.5, 0.5, 0}, {1, 1, 0.5})), 0.25, 2},
            {"a part of an edge", together(box({0, 0, 0}, {0.5, 0.5, 0.5}), box({0.5, 0.5, 0.2}, {1, 1, 0.9})), 0.125 + 0.175, 2},
            {"an edge on a face", together(box({0, 0, 0}, {1, 1, 0.2}), prism({{0.5, 0.2, 0}, {0.8, 0.5, 0}, {0.5, 0.8, 0}}, 0.2, 1)),
             0.2 + 0.8 * 0.09, 1},
            {"a core on the floor of a cavity",
             together(together(box(), inverted(box({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}))), box({0.4, 0.4, 0.2}, {0.6, 0.6, 0.5})),
             1 - 0.216 + 0.012, 2}};
}

}

// Blocks that touch in faces, parts of faces and edges are one solid; so are the same turned about all axes, where what they share agrees to rounding
// alone (seven digits of the file). The volume is that by hand to these digits, the box stays.
TEST(Unite, bodiesThatTouch)
{
    for (const auto& [name, mesh, volume, surfaces] : contacts())
        for (const bool turn : {false, true})
        {
            const auto m = turn ? turned(mesh) : mesh;
            const auto p = prepared(m, "removeSelfIntersections yes;");
            SCOPED_TRACE(std::string(name) + (turn ? ", turned" : ""));
            EXPECT_EQ(p.errors, "");
            EXPECT_NEAR(p.mesh.prepared.volume, volume, 1e-6);
            EXPECT_EQ(p.mesh.prepared.parts, surfaces) << p.repairs;
            expectSameBox(p, m);
        }
}

// Bodies that share a face are refused without the entry, with the advice that the test above has shown to work. Facets that lie back to back, corner on
// corner, are removed without it (Repair.removesDuplicates).
TEST(Unite, onRequestAlone)
{
    for (const auto& [name, mesh, volume, surfaces] : contacts())
        for (const bool turn : {false, true})
        {
            SCOPED_TRACE(std::string(name) + (turn ? ", turned" : ""));
            const auto p = prepared(turn ? turned(mesh) : mesh);
            if (p.errors.empty()) EXPECT_EQ(std::string(name), "the same face") << p.repairs;
            else EXPECT_TRUE(has(p.errors, "removeSelfIntersections yes;")) << p.errors;
        }
}

// A bar that comes back through itself at the same height: of its 12 volumes one is there twice, and its upper and lower sides lie in one plane there.
// 11 is left, not the two ends that are cut off where facets that cross are taken out.
TEST(Unite, aBarThatCrossesItself)
{
    const double w = 0.125; // half of its width
    const auto ring = [&](double x, double y, double dx, double dy) {
        return std::vector<Vector<3>>{{x - dx, y - dy, -w}, {x + dx, y + dy, -w}, {x + dx, y + dy, w}, {x - dx, y - dy, w}};
    };
    // Along x, up, back, and down across itself.
    const auto bar = tube({ring(0, 0, 0, -w), ring(1, 0, w, -w), ring(1, 0.5, w, w), ring(0.5, 0.5, -w, w), ring(0.5, -0.5, -w, 0)});
    for (const bool turn : {false, true})
    {
        const auto m = turn ? turned(bar) : bar;
        EXPECT_TRUE(has(prepared(m).errors, "the surface crosses or touches itself"));
        const auto p = prepared(m, "removeSelfIntersections yes;");
        ASSERT_EQ(p.errors, "");
        EXPECT_NEAR(p.mesh.prepared.volume, 11 * 8 * w * w * w, 1e-6);
        EXPECT_EQ(p.mesh.prepared.parts, 1);
        expectSameBox(p, m);
    }
}

// Against the points that a coil, and a sphere with a dent through its opposite side, wind around: four standard errors of 20,000 points, 2 %.
TEST(Unite, keepsWhatASurfaceWindsAround)
{
    auto dented = icosphere(3);
    for (auto& x : dented.points)
        if (x.x > 0.9) x.x -= 2.2;
    for (const auto& m : {coil(), dented})
    {
        EXPECT_TRUE(has(prepared(m).errors, "the surface crosses or touches itself"));
        const auto p = prepared(m, "removeSelfIntersections yes;");
        ASSERT_EQ(p.errors, "");
        EXPECT_TRUE(has(p.repairs, "of facets of one surface that cross: replaced by the outside of all that it winds around"))
            << p.repairs;
        const auto enclosed = bySolidAngles(m, 20000);
        EXPECT_NEAR(p.mesh.prepared.volume, enclosed.volume, 4 * enclosed.error);
        expectSameBox(p, m);
    }
}

// A box with a cavity, and a rod: right through both, from the wall into the cavity, and within the wall. The cavity stays one, the rod is solid in it.
TEST(Unite, aRodThroughACavity)
{
    const auto hollow = together(box(), inverted(box({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8})));
    const double wall = 1 - 0.216;
    for (const auto& [from, to, volume] :
         {std::tuple{-0.5, 1.5, wall + 0.01 * (0.6 + 1)}, {0.1, 0.5, wall + 0.01 * 0.3}, {0.05, 0.15, wall}})
    {
        const auto m = turned(together(hollow, box({from, 0.45, 0.45}, {to, 0.55, 0.55})));
        const auto p = prepared(m, "removeSelfIntersections yes;");
        SCOPED_TRACE(from);
        if (to < 0.2)
        {
            // It crosses nothing: a third surface, which nests as the file's shells do.
            EXPECT_NEAR(p.mesh.prepared.volume, wall - 0.001, 1e-6);
            continue;
        }
        EXPECT_EQ(p.errors, "");
        EXPECT_NEAR(p.mesh.prepared.volume, volume, 1e-6);
    }
}

// Bodies that are inside out, one or all, are solids: of outermost surfaces nothing else can be meant.
TEST(Unite, bodiesThatAreInsideOut)
{
    const auto a = box(), b = box({0.5, 0.4, 0.3}, {1.5, 1.4, 1.3});
    for (const auto& m : {together(a, inverted(b)), together(inverted(a), b), together(inverted(a), inverted(b))})
    {
        const auto p = prepared(m, "removeSelfIntersections yes;");
        EXPECT_EQ(p.errors, "");
        EXPECT_NEAR(p.mesh.prepared.volume, 2 - 0.5 * 0.6 * 0.7, 1e-6);
    }
    EXPECT_NEAR(prepared(together(a, b), "removeSelfIntersections yes; fluid inside;").mesh.prepared.volume, -(2 - 0.5 * 0.6 * 0.7), 1e-6);
}

// A repair that loses a corner of the box or a part of the volume is refused, and says how much: 0.5 of 1 m along x, 0.5 of 1 m3.
TEST(Unite, refusesALoss)
{
    const auto numbered = [](const Mesh& m)
    {
        NumberedMesh n;
        n.points = m.points;
        n.triangles = m.triangles;
        n.regions = {"all"};
        n.region.assign(m.triangles.size(), 0);
        n.number.assign(m.triangles.size(), 0);
        return n;
    };
    const auto whole = numbered(box());
    EXPECT_NO_THROW(checkNothingIsLost(whole, whole, {1, 1e-3, 100}, 1e-6));
    try
    {
        checkNothingIsLost(numbered(box({0, 0, 0}, {0.5, 1, 1})), whole, {1, 1e-3, 100}, 1e-6);
        FAIL();
    }
    catch (const UnusableMesh& e)
    {
        EXPECT_TRUE(has(e.what(), "0.5 m of its 1 m along x\n    0.5 m3 of the 1 +- 0.001 m3 that it winds around")) << e.what();
    }
}

}
