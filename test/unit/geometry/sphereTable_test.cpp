/// Beds of spheres that other codes have written: the same spheres from each form of table, and mistakes with file and line.
#include "geometry/GeometryCheck.hpp"
#include "geometry/sphereTable.hpp"
#include "reading.hpp"
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

struct Table
{
    std::vector<TableSphere> spheres;
    std::string errors;
};

Table table(const std::string& text)
{
    Diagnostics d;
    auto spheres = spheresInTable(text, "constant/bed.csv", d);
    return {std::move(spheres), messages(d)};
}

}

// A spreadsheet, YADE's textExt, a dump of LIGGGHTS, and diameters in columns of another order.
TEST(SphereTable, ReadsWhatOtherCodesWrite)
{
    for (const std::string text :
         {"x,y,z,radius\n0.1,0.2,0.3,0.05\n0.4,0.5,0.6,0.04\n", "\xEF\xBB\xBFx,y,z,r\n0.1,0.2,0.3,0.05\n0.4,0.5,0.6,0.04\n",
          "#format x_y_z_r\n0.1 0.2 0.3 0.05\n0.4\t0.5\t0.6\t0.04\n",
          "ITEM: TIMESTEP\n1000\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS pp pp ff\n0 1\n0 1\n0 1\n"
          "ITEM: ATOMS id x y z vx radius \n1 0.1 0.2 0.3 0 0.05 \n2 0.4 0.5 0.6 0 0.04 \n",
          "\"Diameter\", Z, Y, X\r\n0.1, 0.3, 0.2, 0.1\r\n\r\n0.08, 0.6, 0.5, 0.4\r\n"})
    {
        const auto [spheres, errors] = table(text);
        ASSERT_EQ(errors, "");
        ASSERT_EQ(spheres.size(), 2u) << text;
        EXPECT_EQ(spheres[0].centre, (Vector<3>{0.1, 0.2, 0.3})) << text;
        EXPECT_EQ(spheres[0].radius, 0.05) << text;
        EXPECT_EQ(spheres[1].centre, (Vector<3>{0.4, 0.5, 0.6})) << text;
        EXPECT_EQ(spheres[1].radius, 0.04) << text;
    }
}

TEST(SphereTable, SaysWhichRowIsWrong)
{
    for (const auto& [text, words] :
         {std::pair{"x,y,z\n0,0,0\n",
                    "constant/bed.csv:1: the columns \"x, y, z\" name no sphere: x, y, z and one of r, radius, d, diameter are needed"},
          {"x,y,z,r\n0,0,0,1\n0,0,0\n", "constant/bed.csv:3: 3 cells under 4 columns"},
          {"0 0 0 1\n0 0 0 -1\n", "constant/bed.csv:2: the sphere has the radius -1; it must be > 0"},
          {"0 0 0 1\n0 0 nan 1\n", "constant/bed.csv:2: \"nan\" is no number"},
          {"x,y,z,r\n0,0,0,\n", "constant/bed.csv:2: \"\" is no number"},
          {"# nothing\n", "constant/bed.csv: there are no spheres in it"},
          {"ITEM: TIMESTEP\n0\nITEM: ATOMS x y z radius\n0 0 0 1\nITEM: TIMESTEP\n1\n",
           "constant/bed.csv:5: a second time of the dump begins here"}})
        EXPECT_TRUE(contains(table(text).errors, words)) << text << "\n" << table(text).errors;
    std::string many = "x,y,z,r\n";
    for (int k = 0; k < 30; ++k) many += "0,0,0,0\n";
    EXPECT_TRUE(contains(table(many).errors, "20 more rows are wrong")) << table(many).errors;
}

// As a wall: scaled and moved, touching neighbours and all; a unit that was forgotten.
TEST(SphereTable, IsAWall)
{
    const auto folder = std::filesystem::path(testing::TempDir()) / "sphereTable";
    std::filesystem::create_directories(folder / "constant");
    std::ofstream(folder / "constant/bed.csv") << "x,y,z,r\n10,20,30,5\n20,20,30,5\n";
    const auto read = [&](const std::string& entries)
    {
        auto diagnostics = std::make_shared<Diagnostics>();
        const auto dict =
            Dictionary::parse("dimension 3; domain { min (0 0 0); max (0.05 0.05 0.05); }\nwalls { bed { type spheres; " + entries + " } }",
                              "constant/geometry", diagnostics);
        auto g = readGeometry(dict, Resolution{.spacing = 1e-3, .where = {}}, 1.5, folder);
        dict.reportUnused();
        return std::pair(std::move(g), messages(*diagnostics));
    };
    const auto [g, errors] = read("file \"bed.csv\"; scale 1e-3; translation (0.001 0 0);");
    EXPECT_EQ(errors, "");
    ASSERT_EQ(g.originals.size(), 2u);
    EXPECT_NEAR(g.distance({0.016, 0.02, 0.03}), 0, 1e-15);
    EXPECT_NEAR(g.distance({0.031, 0.02, 0.03}), 0.005, 1e-15);
    EXPECT_TRUE(
        contains(read("file \"bed.csv\";").second,
                 "the spheres of constant/bed.csv reach over 700 times the extent of the domain: are they in mm? Then `scale 1e-3;`"))
        << read("file \"bed.csv\";").second;
    // One sphere is no longer than a few hundred domains, but far away.
    std::ofstream(folder / "constant/one.csv") << "10 20 30 5\n";
    EXPECT_TRUE(contains(read("file \"one.csv\";").second, "are they in mm?")) << read("file \"one.csv\";").second;
    EXPECT_TRUE(contains(read("file \"none.csv\";").second, "cannot read constant/none.csv")) << read("file \"none.csv\";").second;
    EXPECT_TRUE(contains(read("").second, "either a list `spheres` or a `file`")) << read("").second;
    EXPECT_TRUE(contains(read("file \"bed.csv\"; spheres ((0 0 0 1));").second, "either a list `spheres` or a `file`"));
    std::filesystem::remove_all(folder);
}

// What overlaps too far is named by its rows, also where a period lies between; a list of the dictionary counts its spheres. Clumps, whose spheres leave no
// sharp wedge, are a warning.
TEST(SphereTable, NamesTheRowsThatOverlap)
{
    const auto folder = std::filesystem::path(testing::TempDir()) / "rowsOfSpheres";
    std::filesystem::create_directories(folder / "constant");
    const auto check = [&](const std::string& table, const std::string& entries)
    {
        std::ofstream(folder / "constant/bed.csv") << table;
        auto diagnostics = std::make_shared<Diagnostics>();
        const auto dict =
            Dictionary::parse("dimension 3; domain { min (0 0 0); max (1 1 1); periodic (x); }\nwalls { bed { type spheres; " + entries +
                                  " } }",
                              "constant/geometry", diagnostics);
        const auto g = readGeometry(dict, Resolution{.spacing = 0.02, .where = {}}, 1.5, folder);
        checkGeometry(g, 0.05, *diagnostics);
        std::string warnings;
        for (const auto& w : diagnostics->warnings()) warnings += w + "\n";
        return std::pair(messages(*diagnostics), warnings);
    };
    const std::string rows = "x,y,z,r\n0.5,0.5,0.5,0.1\n0.5,0.2,0.2,0.1\n", file = "file \"bed.csv\";";
    EXPECT_EQ(check(rows + "0.5,0.5,0.69,0.1\n", file).first, "");
    const auto deep = check(rows + "0.5,0.5,0.66,0.1\n", file).first;
    EXPECT_TRUE(contains(deep, "constant/geometry:2: wall \"bed\" and wall \"bed\" overlap near")) << deep;
    EXPECT_TRUE(contains(deep, "by 0.2 of the smaller diameter")) << deep;
    EXPECT_TRUE(contains(deep, ": constant/bed.csv:2 and :4")) << deep;
    const auto across = check(rows + "0.05,0.8,0.8,0.1\n0.89,0.8,0.8,0.1\n", file).first;
    EXPECT_TRUE(contains(across, ": constant/bed.csv:4 and :5")) << across;
    const auto list = check("", "spheres ((0.5 0.2 0.2 0.1) (0.5 0.5 0.5 0.1) (0.5 0.5 0.66 0.1));").first;
    EXPECT_TRUE(contains(list, ": sphere 2 and 3")) << list;
    for (const auto& [clump, how] : {std::pair{"0.5,0.5,0.55,0.1\n", "0.75"}, {"0.5,0.5,0.53,0.06\n", "1.1"}})
    {
        const auto [errors, warnings] = check(rows + clump, file);
        EXPECT_EQ(errors, "");
        EXPECT_TRUE(contains(warnings, fmt::format("by up to {} of the smaller diameter, which leaves no sharp wedge of fluid: are they "
                                                   "parts of one grain? constant/bed.csv:2 and :4",
                                                   how)))
            << warnings;
    }
    const auto twice = check(rows + "0.5,0.5,0.500001,0.1\n", file).first;
    EXPECT_TRUE(contains(
        twice,
        "constant/geometry:2: wall \"bed\" has what is already there, in one place and of one radius to a thousandth, at (0.5 0.5 0.5"))
        << twice;
    EXPECT_TRUE(contains(twice, ": constant/bed.csv:2 and :4")) << twice;
    const auto behind = check(rows + "0.01,0.8,0.8,0.1\n1.010001,0.8,0.8,0.1\n", file).first; // its copy behind the periodic face
    EXPECT_TRUE(contains(behind, ": constant/bed.csv:4 and :5")) << behind;
    std::string many = "x,y,z,r\n";
    for (const double y : {0.1, 0.3, 0.5, 0.7, 0.9})
        for (const double z : {0.2, 0.7}) many += fmt::format("0.5,{0},{1},0.06\n0.6,{0},{1},0.06\n", y, z);
    EXPECT_TRUE(contains(check(many, file).first, " and 5 more")) << check(many, file).first;
    std::filesystem::remove_all(folder);
}

}
