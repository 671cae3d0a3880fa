/// Concave polygons of OBJ, PLY and OFF.
#include "meshes/readers/Polygons.hpp"
#include "Imported.hpp"
#include "Prepared.hpp"
#include <gtest/gtest.h>
#include <numbers>
#include <random>

namespace sph::test::polygonsTest
{

namespace
{

using Outline = std::vector<std::array<double, 2>>;

const Outline lShape{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
const Outline stairs{{0, 0}, {4, 0}, {4, 1}, {3, 1}, {3, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 4}, {0, 4}};
const Outline iBeam{{-3, -2}, {3, -2}, {3, -1.6}, {0.025, -1.6}, {0.025, 1.6},   {3, 1.6},
                    {3, 2},   {-3, 2}, {-3, 1.6}, {-0.025, 1.6}, {-0.025, -1.6}, {-3, -1.6}};

double areaOf(const Outline& outline)
{
    double twice = 0;
    for (std::size_t k = 0; k < outline.size(); ++k)
    {
        const auto &a = outline[k], &b = outline[(k + 1) % outline.size()];
        twice += a[0] * b[1] - a[1] * b[0];
    }
    return twice / 2;
}

/// Scaled into the domain of `Prepared`, so that its volume is told in the file's units.
Prepared scaled(const std::string& file, const std::string& text) { return {file, text, "scale 0.25;"}; }

std::string refusal(const std::string& file, const std::string& text) { return Imported(file, text).refusal; }

/// In a plane that no axis lies in: corners are in it but for rounding.
PolygonMesh turned(PolygonMesh m)
{
    const auto axis = Vector<3>{1, 2, 3} / std::sqrt(14.0);
    for (auto& x : m.points) x = std::cos(1.0) * x + std::sin(1.0) * cross(axis, x) + (1 - std::cos(1.0)) * dot(axis, x) * axis;
    return m;
}

}

// Prisms over an L, stairs of four steps and an I-beam are closed and have their volumes, 3, 10 and 4.96 m3, to 1e-9, in each format that
// has polygons, whichever corner the polygon begins with, upright and turned.
TEST(Polygons, ConcaveBodiesKeepTheirVolume)
{
    for (const auto& [outline, volume] : {std::pair{lShape, 3.0}, {stairs, 10.0}, {iBeam, 4.96}})
        for (std::size_t first = 0; first < outline.size(); ++first)
        {
            auto begun = outline;
            std::rotate(begun.begin(), begun.begin() + std::ptrdiff_t(first), begun.end());
            for (const auto& m : {prism(begun, 1), turned(prism(begun, 1))})
                for (const auto& [file, text] : {std::pair<std::string, std::string>{"a.obj", obj(m)},
                                                 {"a.off", off(m)},
                                                 {"a.ply", ply(m)},
                                                 {"a.ply", binaryPly<double, std::int32_t>(m, "double", "int")}})
                {
                    const Imported i(file, text);
                    ASSERT_EQ(i.refusal, "") << file << first;
                    EXPECT_NEAR(i.volume() / volume, 1, 1e-9) << file << first;
                    EXPECT_TRUE(i.notes.empty());
                    if (first > 0) continue;
                    const auto p = scaled(file, text);
                    ASSERT_EQ(p.errors, "") << file;
                    EXPECT_NEAR(p.mesh.prepared.volume * 64 / volume, 1, 1e-9) << file;
                    EXPECT_EQ(p.mesh.prepared.open, 0u);
                }
        }
}

// Polygons around a point at random radii, of 4 to 60 corners in random planes, half of them with corners in the middle of their edges: n
// - 2 triangles, all turned as the polygon, and its area to 1e-12.
TEST(Polygons, RandomOnesKeepTheirArea)
{
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int trial = 0; trial < 500; ++trial)
    {
        Outline outline;
        const int n = 4 + int(random() % 57);
        for (int k = 0; k < n; ++k)
        {
            const double r = 0.05 + unit(random), a = 2 * std::numbers::pi * (k + 0.9 * unit(random)) / n;
            outline.push_back({r * std::cos(a), r * std::sin(a)});
        }
        if (trial % 2 == 0)
        {
            Outline more;
            for (std::size_t k = 0; k < outline.size(); ++k)
            {
                const auto &a = outline[k], &b = outline[(k + 1) % outline.size()];
                more.insert(more.end(), {a, {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2}});
            }
            outline = more;
        }
        const Vector<3> w{unit(random) - 0.5, unit(random) - 0.5, unit(random) - 0.5}, normal = w / mag(w);
        const auto u = cross(normal, std::abs(normal.x) < 0.5 ? Vector<3>{1, 0, 0} : Vector<3>{0, 1, 0}), e1 = u / mag(u),
                   e2 = cross(normal, e1);
        std::vector<Vector<3>> corners;
        for (const auto& [x, y] : outline) corners.push_back(x * e1 + y * e2 + Vector<3>{3, 4, 5});
        const auto triangles = triangulate(corners);
        EXPECT_EQ(triangles.size(), corners.size() - 2);
        double area = 0;
        for (const auto& [a, b, c] : triangles)
        {
            const double part = 0.5 * dot(normal, cross(corners[std::size_t(b)] - corners[std::size_t(a)],
                                                        corners[std::size_t(c)] - corners[std::size_t(a)]));
            EXPECT_GE(part, -1e-15);
            area += part;
        }
        EXPECT_NEAR(area / areaOf(outline), 1, 1e-12);
        EXPECT_LT(unevenness(corners), 1e-14);
    }
}

// A comb of 20,000 corners is cut in less than ten seconds, where all pairs of corners would take minutes.
TEST(Polygons, ManyCorners)
{
    const int teeth = 5000;
    Outline comb{{0, -1}, {teeth, -1}};
    for (int k = teeth; k > 0; --k) comb.insert(comb.end(), {{double(k), 0}, {k - 0.25, 3}, {k - 0.5, 3}, {k - 0.75, 0}});
    comb.push_back({0, 0});
    const Imported i("a.obj", obj(prism(comb, 1)));
    EXPECT_NEAR(i.volume() / areaOf(comb), 1, 1e-9);
}

// A plate with a hole, joined to its rim by a cut that is passed in both directions, as writers of files without holes do it: 3 x 3 - 1 =
// 8 m3.
TEST(Polygons, HolesByACut)
{
    auto m = prism({{0, 0}, {3, 0}, {3, 3}, {0, 3}}, 1);
    m.faces.erase(m.faces.begin(), m.faces.begin() + 2);
    const int hole = int(m.points.size());
    for (const double z : {0.0, 1.0})
        for (const auto& [x, y] : Outline{{1, 1}, {2, 1}, {2, 2}, {1, 2}}) m.points.push_back({x, y, z});
    for (int k = 0; k < 4; ++k) m.faces.push_back({hole + (k + 1) % 4, hole + k, hole + 4 + k, hole + 4 + (k + 1) % 4});
    m.faces.push_back({4, 5, 6, 7, 4, hole + 4, hole + 7, hole + 6, hole + 5, hole + 4});
    m.faces.push_back({0, 3, 2, 1, 0, hole, hole + 1, hole + 2, hole + 3, hole});
    const auto p = scaled("a.off", off(m));
    ASSERT_EQ(p.errors, "");
    EXPECT_NEAR(p.mesh.prepared.volume * 64, 8, 1e-9);
    EXPECT_EQ(p.mesh.prepared.open, 0u);
}

// Corners twice in one place and a polygon without area leave the body closed.
TEST(Polygons, CornersInOnePlace)
{
    auto text = obj(prism(lShape, 1));
    text += "v 1 1 1\nf 1 1 2 2\nf 7 8 8 7\n";
    text.replace(text.find("f 7 8 9 10"), 10, "f 7 8 9 10 13");
    const auto p = scaled("a.obj", text);
    ASSERT_EQ(p.errors, "");
    EXPECT_NEAR(p.mesh.prepared.volume * 64, 3, 1e-9);
}

// A lid that is bent by a tenth of its length is read, and its two cuts, which differ by 0.017 m3, are told of with the line.
TEST(Polygons, BentOnesAreToldOf)
{
    auto m = prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
    m.points[4].z = 1.1;
    const Imported i("a.obj", obj(m));
    EXPECT_TRUE(std::abs(i.volume() - (1 + 0.1 / 6)) < 1e-12 || std::abs(i.volume() - (1 + 0.1 / 3)) < 1e-12) << i.volume();
    ASSERT_EQ(i.notes.size(), 1u);
    EXPECT_TRUE(has(i.notes[0], "1 polygon is not plane, by up to 0.035 of the size (line 10)")) << i.notes[0];
}

// What crosses or touches itself in its plane is refused with its place in the file.
TEST(Polygons, ThoseThatCrossThemselvesAreRefused)
{
    auto bow = prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
    bow.faces[1] = {4, 6, 5, 7};
    EXPECT_TRUE(
        has(refusal("a.obj", obj(bow)), "line 10: facet 1, a polygon of 4 corners from (0 0 1) on, crosses itself: write it as triangles"))
        << refusal("a.obj", obj(bow));
    EXPECT_TRUE(has(refusal("a.off", off(bow)), "line 12: facet 1, a polygon of 4 corners"));
    EXPECT_TRUE(has(refusal("a.ply", ply(bow)), "line 19: facet 1, a polygon of 4 corners"));
    EXPECT_TRUE(has(refusal("a.ply", binaryPly<float, std::uint8_t>(bow, "float", "uchar")), "byte 274: facet 1, a polygon of 4 corners"))
        << refusal("a.ply", binaryPly<float, std::uint8_t>(bow, "float", "uchar"));
    // A star of five corners goes around its middle twice, a hole that turns as its rim does counts it twice, and a corner lies on an edge.
    const std::string star = "v 0 1 0\nv 0.6 -0.8 0\nv -0.95 0.3 0\nv 0.95 0.3 0\nv -0.6 -0.8 0\nf 1 2 3 4 5\n";
    EXPECT_TRUE(has(refusal("a.obj", star), "line 6: facet 0, a polygon of 5 corners from (0 1 0) on, crosses itself"));
    const std::string hole = "v 0 0 0\nv 3 0 0\nv 3 3 0\nv 0 3 0\nv 1 1 0\nv 2 1 0\nv 2 2 0\nv 1 2 0\nf 1 2 3 4 1 5 6 7 8 5\n";
    EXPECT_TRUE(has(refusal("a.obj", hole), "crosses itself"));
    const std::string touch = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 2 0 0\nv 0 4 0\nf 1 2 3 4 5\n";
    EXPECT_TRUE(has(refusal("a.obj", touch), "touches itself"));
    const std::string back = "v 0 0 0\nv 4 0 0\nv 4 4 0\nf 1 2 3 2\n";
    EXPECT_TRUE(has(refusal("a.obj", back), "runs back along itself and bounds nothing"));
    const std::string behind = "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 4 4 1\nv 0 4 0\nf 1 2 3 4 5\n";
    EXPECT_TRUE(has(refusal("a.obj", behind), "has two corners behind one another"));
}

}
