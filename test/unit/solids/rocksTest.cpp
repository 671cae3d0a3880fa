/// The shapes of rocks are what their names say, and the scan has the faults of one.
#include "TestCase.hpp"
#include "solids/meshDistance.hpp"
#include "solids/rocks/closedSurface.hpp"
#include "solids/rocks/makeRock.hpp"
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

namespace sph::test
{

namespace
{

const RockKind& kind(const std::string& name)
{
    for (const auto& k : rockKinds())
        if (k.name == name) return k;
    throw std::logic_error(name);
}

/// Depth, in diameters, of the surface within its hull: the largest depth of the middle of two points outside of the surface.
double concavity(const TriangleSurface& s)
{
    double deepest = 0;
    for (std::size_t i = 0; i < s.points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
        {
            const auto middle = 0.5 * (s.points[i] + s.points[j]);
            if (!isInside(s, middle)) deepest = std::max(deepest, distanceToSurface(s, middle));
        }
    return deepest;
}

}

// Closed, normals outwards, the volume of the sphere of that diameter about the centroid, and the number of facets that was asked for.
TEST(Rocks, AreClosedAndOfTheSizeAsked)
{
    for (const auto& k : rockKinds())
        for (const int facets : {20, 80, 320, 500})
            for (const std::uint64_t seed : {1, 7})
            {
                const auto rock = makeRock(k, facets, 0.03, seed);
                EXPECT_EQ(looseEdges(rock), 0u) << k.name << facets;
                const auto moments = volumeMoments(rock);
                EXPECT_NEAR(moments.volume / (std::numbers::pi / 6 * 0.03 * 0.03 * 0.03), 1, 1e-12) << k.name << facets;
                EXPECT_LT(mag(moments.centroid), 1e-14) << k.name;
                EXPECT_EQ(rock.triangles.size(), std::size_t(facets)) << k.name;
                // Euler's formula of a sphere: no handles, no second shell
                EXPECT_EQ(rock.points.size() + rock.triangles.size() - 3 * rock.triangles.size() / 2, 2u) << k.name;
            }
}

// The concave rock has a place a tenth of its diameter within its hull; polyhedra are convex to rounding.
TEST(Rocks, OnlyTheConcaveOneIsConcave)
{
    for (const std::uint64_t seed : {1, 2, 3})
    {
        EXPECT_GT(concavity(makeRock(kind("concave"), 80, 1, seed)), 0.1);
        for (const auto* name : {"angular", "elongated", "flat"}) EXPECT_LT(concavity(makeRock(kind(name), 80, 1, seed)), 1e-9) << name;
        EXPECT_LT(concavity(makeRock(kind("rounded"), 80, 1, seed)), 0.03);
    }
}

// By the principal moments, the rod is more than 1.5 times as long as wide, the disc more than 1.5 times as wide as thick (Zingg 1935).
TEST(Rocks, RodsAndDiscs)
{
    for (const std::uint64_t seed : {1, 2, 3})
    {
        const auto rod = volumeMoments(makeRock(kind("elongated"), 80, 1, seed)).second;
        EXPECT_GT(std::sqrt(rod.xx / rod.yy), 1.5);
        EXPECT_LT(std::sqrt(rod.yy / rod.zz), 1.5);
        const auto disc = volumeMoments(makeRock(kind("flat"), 80, 1, seed)).second;
        EXPECT_LT(std::sqrt(disc.xx / disc.yy), 1.5);
        EXPECT_GT(std::sqrt(disc.yy / disc.zz), 1.5);
    }
}

// A scan has holes, facets twice and the wrong way round, and its points are off the rock that it was made from by half a percent or so.
TEST(Rocks, TheScanHasItsFaults)
{
    const auto scan = makeScan(2000, 1, 3);
    const auto rock = makeRock(kind("rounded"), 2000, 1, 3);
    std::set<std::array<int, 3>> different;
    std::size_t reversed = 0;
    for (const auto& t : scan.triangles)
    {
        different.insert(t);
        reversed += dot(cross(scan.points[std::size_t(t[1])] - scan.points[std::size_t(t[0])],
                              scan.points[std::size_t(t[2])] - scan.points[std::size_t(t[0])]),
                        scan.points[std::size_t(t[0])]) < 0;
    }
    EXPECT_LT(different.size(), scan.triangles.size());
    EXPECT_GT(reversed, 10u);
    EXPECT_LT(scan.triangles.size(), rock.triangles.size());
    EXPECT_GT(looseEdges(scan), 100u);
    double sum = 0;
    std::size_t astray = 0;
    for (std::size_t i = 0; i < scan.points.size(); ++i)
    {
        const double off = mag(scan.points[i] - rock.points[i]);
        if (off > 0.05) ++astray;
        else sum += off * off;
    }
    EXPECT_EQ(astray, 2u);
    EXPECT_NEAR(std::sqrt(sum / double(scan.points.size())), 0.005, 0.0005);
}

// Files read back: OBJ, and OFF as another of the formats that walls are read in, to the last bit; binary STL to single precision with
// its points welded.
TEST(Rocks, FilesReadBack)
{
    const auto rock = makeRock(kind("angular"), 80, 1, 1);
    auto off = fmt::format("OFF\n{} {} 0\n", rock.points.size(), rock.triangles.size());
    for (const auto& p : rock.points) off += fmt::format("{} {} {}\n", p.x, p.y, p.z);
    for (const auto& [a, b, c] : rock.triangles) off += fmt::format("3 {} {} {}\n", a, b, c);
    const TestCase folder({{"a.obj", objText({{"a", rock}})}, {"a.stl", stlBytes(rock)}, {"a.off", off}});
    const auto obj = readSurface(folder.folder(), "a.obj");
    EXPECT_EQ(obj.points, rock.points);
    EXPECT_EQ(obj.triangles, rock.triangles);
    EXPECT_EQ(readSurface(folder.folder(), "a.off").points, rock.points);
    const auto stl = readSurface(folder.folder(), "a.stl");
    EXPECT_EQ(looseEdges(stl), 0u);
    EXPECT_EQ(stl.points.size(), rock.points.size());
    EXPECT_NEAR(volumeMoments(stl).volume, volumeMoments(rock).volume, 1e-6);
}

// makeRocks writes all kinds and the scan; the same seed makes the same bytes, another seed others; what it does not know it says.
TEST(Rocks, MakeRocks)
{
    const TestCase a({}), b({}), c({});
    a.runWell("makeRocks", "-count 2");
    b.runWell("makeRocks", "-count 2");
    c.runWell("makeRocks", "-count 2 -seed 2");
    EXPECT_EQ(a.files("constant").size(), 12u);
    EXPECT_EQ(difference(a.files("constant"), b.files("constant")), "");
    EXPECT_NE(a.read("constant/triSurface/flat1.obj"), c.read("constant/triSurface/flat1.obj"));
    const auto wrong = a.run("makeRocks", "-kind angula");
    EXPECT_EQ(wrong.code, 1);
    EXPECT_NE(wrong.err.find("-kind: \"angula\" is unknown. Did you mean \"angular\"?"), std::string::npos) << wrong.err;
    EXPECT_NE(a.run("makeRocks", "-facets 3").err.find("-facets 3: at least 20"), std::string::npos);
}

}
