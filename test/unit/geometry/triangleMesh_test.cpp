/// Meshes as walls: signed distance, bodies and cavities, regions, files.
#include "geometry/TriangleMesh.hpp"
#include "geometry/Walls.hpp"
#include "meshes.hpp"
#include "reading.hpp"
#include <fstream>
#include <gtest/gtest.h>
#include <numbers>

using namespace sph;
using namespace sph::test;

namespace
{

constexpr FacetScale scale{0.1, 0.26};

// The nearest place of a cube by its mathematics, at 1000 places in and around it: faces, edges and corners.
TEST(TriangleMesh, TellsTheSignedDistanceToACube)
{
    const auto bodies = bodiesOf(ofOneRegion(block({0, 0, 0}, {1, 1, 1})), scale);
    ASSERT_EQ(bodies.size(), 1u);
    for (int k = 0; k < 1000; ++k)
    {
        const auto at = [&](int n) { return -0.5 + 0.2217 * (k / n % 10); };
        const Vector<3> x{at(1), at(10), at(100)};
        const Vector<3> q{std::abs(x.x - 0.5) - 0.5, std::abs(x.y - 0.5) - 0.5, std::abs(x.z - 0.5) - 0.5};
        const auto out = [](double a) { return std::max(a, 0.0); };
        const double expected = mag(Vector<3>{out(q.x), out(q.y), out(q.z)}) + std::min(std::max({q.x, q.y, q.z}), 0.0);
        const auto foot = bodies[0]->foot(x);
        EXPECT_NEAR(foot.distance, expected, 1e-14);
        EXPECT_NEAR(bodies[0]->foot(x - foot.distance * foot.normal).distance, 0, 1e-14);
    }
    EXPECT_NEAR(bodies[0]->volume(), 1, 1e-14);
    EXPECT_TRUE(std::isnan(bodies[0]->distance({std::nan(""), 0, 0})));
    EXPECT_EQ(bodies[0]->foot({5, 0, 0}, 1).distance, Box::infinity);
}

// A bound that is never wrong, for the fluid around a body and for that in it, and that spares most places further off than a cell's half diagonal a search.
TEST(TriangleMesh, KnowsWhatIsFarOff)
{
    for (const bool inside : {false, true})
    {
        const auto s = icosphere(3, 1);
        const auto body = bodiesOf(ofOneRegion(inside ? inverted(s) : s), scale)[0];
        int far = 0, known = 0;
        for (int k = 0; k < 8000; ++k)
        {
            const auto at = [&](int n) { return -1.3 + 0.1371 * (k / n % 20); };
            const Vector<3> x{at(1), at(20), at(400)};
            const double d = body->distance(x);
            for (const double least : {0.0, 0.05}) EXPECT_TRUE(!body->isBeyond(x, least) || d > least) << x.x << " " << x.y << " " << x.z;
            far += d > std::sqrt(3) * scale.spacing;
            known += d > std::sqrt(3) * scale.spacing && body->isBeyond(x, 0);
        }
        EXPECT_GT(far, 500);
        EXPECT_EQ(known, far);
        EXPECT_FALSE(body->isBeyond({std::nan(""), 0, 0}, 0));
    }
}

// A cube as seen by the fluid around it and by the fluid in it: six faces; every edge convex, or concave.
TEST(TriangleMesh, TellsConvexFromConcave)
{
    for (const bool inside : {false, true})
    {
        const auto s = block({0, 0, 0}, {1, 1, 1});
        const auto body = bodiesOf(ofOneRegion(inside ? inverted(s) : s), scale)[0];
        EXPECT_EQ(body->patches(), 6);
        for (const auto& f : body->facets())
            for (const auto edge : f.edges) EXPECT_TRUE(edge == EdgeKind::flat || edge == (inside ? EdgeKind::concave : EdgeKind::convex));
    }
}

// Small facets stand for the sphere: one patch, whose curvatures are those of the sphere to 1 %, of either sign.
TEST(TriangleMesh, TellsTheCurvatureThatSmallFacetsStandFor)
{
    const double R = 1;
    for (const bool inside : {false, true})
    {
        const auto s = icosphere(4, R);
        const auto body = bodiesOf(ofOneRegion(inside ? inverted(s) : s), scale)[0];
        EXPECT_EQ(body->patches(), 1);
        EXPECT_FALSE(body->hasCreases());
        double sum = 0;
        int n = 0;
        for (double a = 0.1; a < 3; a += 0.2)
            for (double b = 0.05; b < 6; b += 0.3, ++n)
            {
                const double d = 0.1;
                const Vector<3> e{std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)};
                int mirrors = 0;
                body->forEachMirror((inside ? R - d : R + d) * e, 0.3, 0, 0, {},
                                    [&](int, const Foot& f)
                                    {
                                        ++mirrors;
                                        sum += volumeFactor(f);
                                        EXPECT_NEAR(f.distance, d, 0.006);
                                        EXPECT_NEAR(dot(f.normal, e), inside ? -1 : 1, 1e-3);
                                    });
                EXPECT_EQ(mirrors, 1);
            }
        const double expected = inside ? std::pow((R + 0.1) / (R - 0.1), 2) : std::pow((R - 0.1) / (R + 0.1), 2);
        EXPECT_NEAR(sum / n, expected, 0.01 * expected);
    }
}

// Two blocks are two bodies, also where they overlap; the hollow in a block belongs to it; a vessel around blocks is a body of its own.
TEST(TriangleMesh, TakesBodiesApartAndLeavesCavitiesTogether)
{
    const auto small = block({0.2, 0.2, 0.2}, {0.8, 0.8, 0.8}), big = block({0, 0, 0}, {1, 1, 1});
    EXPECT_EQ(bodiesOf(ofOneRegion(together(big, block({0.9, 0.9, 0.9}, {2, 2, 2}))), scale).size(), 2u);
    const auto hollow = bodiesOf(ofOneRegion(together(big, inverted(small))), scale);
    ASSERT_EQ(hollow.size(), 1u);
    EXPECT_NEAR(hollow[0]->distance({0.5, 0.5, 0.5}), 0.3, 1e-14);
    EXPECT_NEAR(hollow[0]->distance({0.5, 0.5, 0.1}), -0.1, 1e-14);
    EXPECT_NEAR(hollow[0]->distance({0.5, 0.5, -0.1}), 0.1, 1e-14);
    EXPECT_EQ(bodiesOf(ofOneRegion(together(inverted(big), small)), scale).size(), 2u);
}

/// A case with a mesh that has been prepared.
struct MeshCase
{
    std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / testing::UnitTest::GetInstance()->current_test_info()->name();
    std::shared_ptr<Diagnostics> diagnostics = std::make_shared<Diagnostics>();
    FacetSurface surface = ofOneRegion(block({0.25, 0.25, 0.25}, {0.75, 0.75, 0.75}));

    MeshCase()
    {
        surface.regions = {"sides", "top"};
        for (std::size_t f = 0; f < surface.triangles.size(); ++f)
        {
            bool isTop = true;
            for (const int p : surface.triangles[f]) isTop = isTop && surface.points[std::size_t(p)].z == 0.75;
            surface.region[f] = isTop;
        }
        writeWallMesh(folder, "rock", surface);
    }
    ~MeshCase() { std::filesystem::remove_all(folder); }
    Geometry read(const std::string& more = "")
    {
        const auto dict =
            Dictionary::parse("dimension 3; domain { min (0 0 0); max (1 1 1); }\nwalls { rock { type triSurface; file \"rock.stl\"; "
                              "fluid outside; contactAngle 30; " +
                                  more + " } }",
                              "constant/geometry", diagnostics);
        auto g = readGeometry(dict, Resolution{.spacing = 0.05, .where = {}}, 1, folder);
        dict.reportUnused();
        return g;
    }
    std::string errors()
    {
        try
        {
            diagnostics->throwIfAny();
        }
        catch (const CaseError& e)
        {
            return e.what();
        }
        return "";
    }
};

// A region of the mesh is a wall of its own, with its contact angle; constant/walls says the same to the solver.
TEST(TriangleMesh, RegionsAreWalls)
{
    MeshCase c;
    const auto g = c.read("regions { top { contactAngle 90; velocity (1 0 0); } }");
    ASSERT_EQ(c.errors(), "");
    ASSERT_EQ(g.walls.size(), 2u);
    EXPECT_EQ(g.walls[1].name, "rock.top");
    const auto wallAt = [](const Geometry& of, const Vector<3>& x) { return of.patches[0].wallAt(of.foot(0, x).region); };
    for (const auto& each : {g, readWalls(Dictionary::parse(wallsText(g, "0123"), "constant/walls", c.diagnostics),
                                          Resolution{.spacing = 0.05, .where = {}}, c.folder)})
    {
        EXPECT_EQ(wallAt(each, {0.5, 0.5, 0.8}), 1);
        EXPECT_EQ(wallAt(each, {0.5, 0.2, 0.5}), 0);
        EXPECT_EQ(each.walls[1].contactAngle, 90);
        EXPECT_EQ(each.walls[1].velocity, (Vector<3>{1, 0, 0}));
    }
    EXPECT_EQ(c.errors(), "");
}

// A region slips or rubs as the mesh does, unless it says otherwise.
TEST(TriangleMesh, RegionsSlip)
{
    for (const auto& [entries, whole, top] : {std::tuple{"slip yes; regions { top { contactAngle 90; } }", true, true},
                                              {"slip yes; regions { top { slip no; } }", true, false},
                                              {"regions { top { slip yes; } }", false, true}})
    {
        MeshCase c;
        const auto g = c.read(entries);
        ASSERT_EQ(c.errors(), "");
        EXPECT_EQ(g.walls[0].slips, whole) << entries;
        EXPECT_EQ(g.walls[1].slips, top) << entries;
    }
    for (const auto& [entries, angle] : {std::pair{"frictionAngle 20; regions { top { contactAngle 90; } }", 20},
                                         {"frictionAngle 20; regions { top { frictionAngle 30; } }", 30},
                                         {"frictionAngle 20; regions { top { slip no; } }", -1}})
    {
        MeshCase c;
        const auto g = c.read(entries);
        ASSERT_EQ(c.errors(), "");
        EXPECT_EQ(g.walls[0].frictionAngle, 20) << entries;
        EXPECT_EQ(g.walls[1].frictionAngle.value_or(-1), angle) << entries;
    }
}

TEST(TriangleMesh, MistakesOfRegionsAndFilesAreNamed)
{
    {
        MeshCase c;
        c.read("regions { topp { contactAngle 90; } }");
        EXPECT_NE(c.errors().find("region \"topp\" is unknown. Did you mean \"top\"?"), std::string::npos) << c.errors();
    }
    {
        MeshCase c;
        std::filesystem::remove_all(c.folder / "constant");
        c.read();
        EXPECT_NE(c.errors().find("constant/wallMeshes/rock: is missing: run meshToGhost"), std::string::npos) << c.errors();
    }
    const std::string header = "FoamFile { format ascii; class wallMesh; }\n";
    for (const auto& [text, message] :
         {std::pair{header + "regions (a) points 1 ( (0 0 nan) ) facets 0 ()", ":2: expected a coordinate"},
          {header + "regions (a) points 1 ( (0 0 0) ) facets 1 ( (0 0 1 0) )", ":2: expected the number of a point"},
          {header + "regions (a) points 99 ( (0 0 0)", "greater than what follows"},
          {"FoamFile { format ascii;", ":1: the FoamFile header does not end"},
          {"FoamFile { format ascii; }", ":1: the FoamFile header has no \"class\""},
          {"FoamFile\n{\nformat ascii;\nclass scalarField;\n}", ":4: class \"scalarField\" in ascii, not wallMesh in ascii"},
          {"FoamFile { format binary; class wallMesh; }", ":1: class \"wallMesh\" in binary, not wallMesh in ascii"},
          {"", "no FoamFile header"}})
    {
        MeshCase c;
        std::ofstream(c.folder / "constant/wallMeshes/rock") << text;
        c.read();
        EXPECT_NE(c.errors().find(message), std::string::npos) << c.errors();
    }
}

// A block of triangles half sunk into a floor: its facets below are hidden, and the sides have the images of a corner.
TEST(TriangleMesh, FacetsInOtherSolidsAreHidden)
{
    MeshCase c;
    auto s = c.surface;
    for (auto& p : s.points) p.z -= 0.5;
    writeWallMesh(c.folder, "rock", s);
    const auto dict =
        Dictionary::parse("dimension 3; domain { min (0 0 0); max (1 1 1); } walls { floor { type plane; point (0 0 0); normal (0 0 1); } "
                          "rock { type triSurface; file \"rock.stl\"; fluid outside; } }",
                          "constant/geometry", c.diagnostics);
    const auto g = readGeometry(dict, Resolution{.spacing = 0.05, .where = {}}, 1, c.folder);
    ASSERT_EQ(c.errors(), "");
    const auto& mesh = *g.patches[1].mesh;
    int hidden = 0;
    for (const char h : mesh.hidden()) hidden += h;
    EXPECT_EQ(hidden, 2);
}

}
