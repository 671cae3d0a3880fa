#include "geometry/Walls.hpp"
#include "reading.hpp"
#include <fstream>
#include <gtest/gtest.h>

using namespace sph;
using namespace sph::test;

// constant/walls gives back every number: all shapes, periodic and endless ones, written, read and written again.
TEST(Walls, surviveWritingAndReading)
{
    const std::string domain3 = "dimension 3; domain { min (0 0 0); max (1 1 1); periodic (z); }\n";
    for (
        const auto& text :
        {domain3 +
             "walls { a { type plane; point (0.1 0 0); normal (1 2 0); contactAngle 33.3; velocity (0.1 0 0); omega (0 0 "
             "1); origin (0.3 0 0); }"
             " b { type cylinder; point (0.3 0.3333333333333333 0); axis (0 0 1); radius 0.1; fluid outside; contactAngles ( (water air) 30.5 (oil air) 60 ); }"
             " c { type torus; centre (0.5 0.5 0.5); axis (1 2 3); ringRadius 0.2; tubeRadius 0.05; fluid outside; }"
             " d { type ellipsoid; centre (0.8 0.8 0.8); semiAxes (0.1 0.07 0.03); fluid outside; }"
             " e { type box; min (0.1 0.7 0); max (0.2 0.9 1); fluid outside; }"
             " f { type box; min (0 0 0); max (1 1 1); fluid inside; } }",
         std::string(
             "dimension 3; domain { min (0 0 0); max (1 1 1); }\n"
             "walls { a { type cone; apex (0 0 0.1); axis (1 1 1); halfAngle 30; fluid inside; }"
             " b { type sphere; centre (0.3 0.3 0.3); radius 0.1; fluid outside; slip yes; } c { type plane; point (0 0 0); normal (1 0 0); frictionAngle 12.5; } }"),
         square + "walls { b { type ellipsoid; centre (0.8 0.8 0); semiAxes (0.1 0.07 0); fluid outside; } }", bcc("0.5")})
    {
        const auto [g, errors] = read(text);
        ASSERT_EQ(errors, "");
        const auto written = wallsText(g, "0123");
        auto diagnostics = std::make_shared<Diagnostics>();
        const auto dict = Dictionary::parse(written, "constant/walls", diagnostics);
        const auto again = readWalls(dict, Resolution{.spacing = 1e-3, .where = {}});
        dict.reportUnused();
        EXPECT_NO_THROW(diagnostics->throwIfAny());
        EXPECT_EQ(wallsText(again, dict.get<std::string>("stamp")), written);
        EXPECT_EQ(again.patches.size(), g.patches.size());
        EXPECT_EQ(again.reach, g.reach);
        EXPECT_EQ(again.walls[0].wets, g.walls[0].wets);
        EXPECT_EQ(again.slips(), g.slips());
        ASSERT_EQ(again.withFriction() != nullptr, g.withFriction() != nullptr);
        if (g.withFriction()) { EXPECT_EQ(again.withFriction()->frictionAngle, g.withFriction()->frictionAngle); }
        EXPECT_EQ(toString(again.walls[0].anglesAt), toString(g.walls[0].anglesAt));
    }
}

// The stamp follows the text, included files and the resolution.
TEST(Walls, stampChangesWithTheSource)
{
    const auto folder = std::filesystem::path(testing::TempDir()) / "geometryStamp";
    std::filesystem::create_directories(folder / "constant");
    const auto write = [&](const std::string& name, const std::string& text) { std::ofstream(folder / "constant" / name) << text; };
    write("geometry", "dimension 3;\n#include \"spheres\"\n");
    write("spheres", "spheres ((0 0 0 1));\n");
    const auto stamp = geometryStamp(folder, 1e-4, 2.6);
    EXPECT_EQ(stamp.size(), 16u);
    EXPECT_EQ(geometryStamp(folder, 1e-4, 2.6), stamp);
    EXPECT_NE(geometryStamp(folder, 1e-4, 3), stamp);
    write("spheres", "spheres ((0 0 0 2));\n");
    EXPECT_NE(geometryStamp(folder, 1e-4, 2.6), stamp);
    write("spheres", "file \"bed.csv\";\n");
    write("bed.csv", "0 0 0 1\n");
    const auto ofTable = geometryStamp(folder, 1e-4, 2.6);
    write("bed.csv", "0 0 0 2\n");
    EXPECT_NE(geometryStamp(folder, 1e-4, 2.6), ofTable);
    std::filesystem::remove_all(folder);
}
