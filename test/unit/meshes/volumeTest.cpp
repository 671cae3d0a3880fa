/// Walls from volumes of voxels. The solid is that of touching spheres in a body-centred cubic cell, whose porosity is exact: 1 - pi sqrt(3)/8 = 0.319825. The sides of
/// the volume cut eight of them, and necks of one voxel and more join them where they touch.
#include "Prepared.hpp"
#include "meshes/SolidOfFile.hpp"
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

namespace sph::test::volumeTest
{

namespace
{

const double exactPorosity = 1 - std::numbers::pi * std::sqrt(3.0) / 8;

/// Distance from the surface of the nearest sphere, negative inside, in the cell (0 0 0) to (1 1 1).
double distanceFromSolid(const Vector<3>& x)
{
    double nearest = mag(x - Vector<3>{0.5, 0.5, 0.5});
    for (const double a : {0.0, 1.0})
        for (const double b : {0.0, 1.0})
            for (const double c : {0.0, 1.0}) nearest = std::min(nearest, mag(x - Vector<3>{a, b, c}));
    return nearest - std::sqrt(3.0) / 4;
}

/// A byte for each of n x n x n voxels of the cell.
std::string bytes(int n, const std::function<double(double distance)>& value)
{
    std::string all;
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i)
                all += char(std::uint8_t(std::lround(value(distanceFromSolid({(i + 0.5) / n, (j + 0.5) / n, (k + 0.5) / n})))));
    return all;
}

std::string segmented(int n)
{
    return bytes(n, [](double d) { return d < 0 ? 2 : 1; });
}

/// 100 on the surface, 40 more a voxel into the solid.
std::string grey(int n)
{
    return bytes(n, [n](double d) { return std::clamp(100 - 40 * d * n, 0.0, 200.0); });
}

std::string header(int n, const std::string& more)
{
    return "ObjectType = Image\nNDims = 3\n" + more + "DimSize = " + std::to_string(n) + " " + std::to_string(n) + " " + std::to_string(n) +
           "\nElementType = MET_UCHAR\nElementDataFile = LOCAL\n";
}

Prepared volume(const std::string& text, const std::string& entries) { return {"scan.mha", text, entries}; }

double porosityOf(const Prepared& p) { return 1 - std::abs(p.mesh.prepared.volume); }

}

// Segmented, smoothed: the surface keeps the porosity of the voxels to 0.1 % of the void, and has that of the spheres to 0.5 % at 40 voxels a cell, 17 to a radius. It is one closed body
// without any repair that has to be asked for.
TEST(Volume, ofLabels)
{
    const auto p = volume(header(40, "ElementSpacing = 25 25 25\n") + segmented(40), "scale 1e-3; volume { label 2; }");
    ASSERT_EQ(p.errors, "");
    ASSERT_EQ(p.mesh.notes.size(), 1u);
    EXPECT_TRUE(has(p.mesh.notes[0], "40 x 40 x 40 voxels of 25 x 25 x 25: porosity 0.3")) << p.mesh.notes[0];
    EXPECT_NEAR(porosityOf(p) / exactPorosity, 1, 5e-3) << p.mesh.notes[0];
    const double byVoxels = std::stod(p.mesh.notes[0].substr(p.mesh.notes[0].find("porosity ") + 9));
    EXPECT_NEAR(porosityOf(p) / byVoxels, 1, 2e-3) << p.mesh.notes[0];
    EXPECT_EQ(p.mesh.prepared.parts, 1u);
    EXPECT_EQ(p.mesh.prepared.open + p.mesh.prepared.multiple, 0u);
    // The sides of the volume are planes.
    const auto& box = p.mesh.prepared.box;
    EXPECT_NEAR(mag(box.low), 0, 1e-6);
    EXPECT_NEAR(mag(box.high - Vector<3>{1, 1, 1}), 0, 1e-6);
}

// Grey values place the surface between voxels: 0.1 % of the void at 40 voxels a cell. Solid below the threshold, and the same values the other way round, are the same surface.
TEST(Volume, ofGreyValues)
{
    const auto p =
        volume(header(40, "ElementSpacing = 0.025 0.025 0.025\nOffset = 0.0125 0.0125 1.0125\n") + grey(40), "volume { threshold 100; }");
    ASSERT_EQ(p.errors, "");
    EXPECT_NEAR(porosityOf(p) / exactPorosity, 1, 3e-3) << p.mesh.notes[0];
    EXPECT_NEAR(p.mesh.prepared.box.low.z, 1, 1e-6); // the centre of the first voxel lies at the offset
    auto inverted = grey(40);
    for (auto& c : inverted) c = char(200 - std::uint8_t(c));
    const auto below = volume(header(40, "ElementSpacing = 0.025 0.025 0.025\n") + inverted, "volume { threshold 100; solid below; }");
    ASSERT_EQ(below.errors, "");
    EXPECT_NEAR(porosityOf(below), porosityOf(p), 1e-9);
}

// A raw file is what the dictionary says: the same surface as that of a MetaImage.
TEST(Volume, raw)
{
    const Prepared raw("scan.raw", "0123456789" + grey(24),
                       "volume { threshold 100; voxelSize 0.04; cells (24 24 24); dataType uint8; headerBytes 10; }");
    const auto meta = volume(header(24, "ElementSpacing = 0.04 0.04 0.04\n") + grey(24), "volume { threshold 100; }");
    ASSERT_EQ(raw.errors + meta.errors, "");
    EXPECT_EQ(raw.mesh.surface.points, meta.mesh.surface.points);
    EXPECT_EQ(raw.mesh.surface.triangles, meta.mesh.surface.triangles);
}

// Whether a point lies in the solid is told by the same surface.
TEST(Volume, solidOfFile)
{
    TemporaryCase scene;
    scene.write("constant/triSurface/scan.mha", header(24, "ElementSpacing = 1 1 1\n") + grey(24));
    TriSurface wall;
    wall.file = "scan.mha";
    wall.scale = 1.0 / 24;
    wall.volume.emplace().threshold = 100;
    const SolidOfFile solid(scene.folder(), wall, {.low = {-2, -2, -2}, .high = {2, 2, 2}, .spacing = 0.01, .H = 0.026});
    EXPECT_TRUE(solid.contains({0.5, 0.5, 0.5}));
    EXPECT_TRUE(solid.contains({0.1, 0.1, 0.1}));
    EXPECT_FALSE(solid.contains({0.5, 0, 0.5}));
    EXPECT_FALSE(solid.contains({-0.01, 0.01, 0.01})); // beyond the volume
}

// Each mistake says what is wrong and what to do, with the line of the wall or of its section.
TEST(Volume, mistakes)
{
    const auto errorOf = [](const std::string& text, const std::string& entries, const std::string& file = "scan.mha")
    { return Prepared(file, text, entries).errors; };
    const auto cube = segmented(8);
    const std::string spacing = "ElementSpacing = 0.1 0.1 0.1\n", place = "constant/geometry:4: constant/triSurface/scan.mha: ";
    for (
        const auto& [error, what] : std::vector<std::pair<std::string, std::string>>{
            {errorOf(header(8, "") + cube, "volume { label 2; }"),
             "constant/geometry:4: constant/triSurface/scan.mha: its header has no ElementSpacing, so that nobody knows how large a voxel is: add voxelSize"},
            {errorOf(header(8, "ElementSpacing = 0.1 0 0.1\n") + cube, "volume { label 2; }"),
             "ElementSpacing of its header is 0.1 0 0.1, and must be positive"},
            {errorOf(cube, "volume { label 2; cells (8 8 8); dataType uint8; }", "scan.raw"),
             "nobody knows how large a voxel of scan.raw is: add `voxelSize`"},
            {errorOf(cube, "volume { label 2; voxelSize 0.1; cells (8 8 9); dataType uint8; }", "scan.raw"),
             "8 x 8 x 9 voxels of uint8 are 576 bytes, and there are 512"},
            {errorOf(cube, "volume { label 2; voxelSize 0.1; cells (8 8); dataType uint8; }", "scan.raw"),
             "three numbers of voxels are needed, and there are 2"},
            {errorOf(cube, "volume { label 2; voxelSize 0.1; dataType uint8; }", "scan.raw"), "entry \"cells\" is missing in \"volume\""},
            {errorOf(header(8, spacing) + cube, "volume { label 7; }"),
             place + "none of its voxels are solid by label 7: their values go from"},
            {errorOf(header(8, spacing) + cube, "volume { threshold 1; }"),
             "all of its voxels are solid by threshold 1: their values go from 1 to 2"},
            {errorOf(header(8, spacing) + cube, "volume { }"),
             "constant/geometry:6: a volume needs either `threshold`, the grey value from which on it is solid, or `label`"},
            {errorOf(header(8, spacing) + cube, ""),
             "constant/geometry:4: scan.mha is a volume of voxels: add what of it is solid, `volume { label 1; }`"},
            {errorOf(header(8, spacing + "CompressedData = True\n") + cube, "volume { label 2; }"),
             "its data are compressed: write it with CompressedData = False"},
            {errorOf(header(8, spacing + "TransformMatrix = 0 1 0 1 0 0 0 0 1\n") + cube, "volume { label 2; }"),
             "TransformMatrix of its header turns the volume"},
            {errorOf("nonsense", "volume { label 2; }"), "no header of a MetaImage: it has no line ElementDataFile = ..."},
            {errorOf(header(8, "ElementSpacing = 100 100 100\n") + cube, "volume { label 2; }"),
             "the mesh is 800 m long, 200 x the domain ("}})
        EXPECT_TRUE(has(error, what)) << what << "\nin\n" << error;
}

}
