/// PLY as programs write it. Each file is a box of 1 m3 with faces of four corners.
#include "Imported.hpp"
#include <gtest/gtest.h>

namespace sph::test::readPlyTest
{

namespace
{

const PolygonMesh cube = prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);

void expectBox(const std::string& bytes, const std::string& notes = "", double volume = 1)
{
    const Imported i("a.ply", bytes);
    EXPECT_EQ(i.refusal, "");
    EXPECT_DOUBLE_EQ(i.volume(), volume);
    EXPECT_EQ(i.regions(), "patch0 12");
    EXPECT_EQ(i.allNotes(), notes);
}

void expectRefusal(const std::string& bytes, const std::string& why) { EXPECT_EQ(Imported("a.ply", bytes).refusal, why); }

std::string crlfHeader(const std::string& bytes)
{
    const auto data = bytes.find("end_header\n") + 11;
    return replacedAll(bytes.substr(0, data), "\n", "\r\n") + bytes.substr(data);
}

}

// Numbers of any type in both byte orders; the box of small whole numbers fits into each.
TEST(ReadPly, NumbersOfAnyType)
{
    for (const bool big : {false, true})
    {
        expectBox(binaryPly<float, std::uint8_t>(cube, "float", "uchar", big));
        expectBox(binaryPly<double, std::int8_t>(cube, "float64", "int8", big));
        expectBox(binaryPly<std::int8_t, std::int16_t>(cube, "char", "short", big));
        expectBox(binaryPly<std::uint16_t, std::uint16_t>(cube, "uint16", "ushort", big));
        expectBox(binaryPly<std::int32_t, std::uint32_t>(cube, "int", "uint32", big));
        expectBox(binaryPly<double, float>(cube, "double", "float", big));
    }
    expectBox(replacedAll(plyHeader(cube, "ascii", "float", "uint"), "float", "int") + pointRows(cube) + faceRows(cube));
}

// The header's lines may end in CRLF or CR, and the first byte of data may be 0x0A or 0x0D: the x of the first point, big-endian.
TEST(ReadPly, FirstByteThatLooksLikeAnEndOfLine)
{
    for (const int first : {0x0A, 0x0D})
    {
        // 0x0A000000 and 0x0D000000 as int; the others follow at a distance of 2^24.
        auto m = cube;
        for (auto& p : m.points) p.x = (first + p.x) * 16777216;
        const auto bytes = binaryPly<std::int32_t, std::int32_t>(m, "int", "int", true);
        ASSERT_EQ(bytes[bytes.find("end_header\n") + 11], char(first));
        expectBox(bytes, "", 16777216);
        expectBox(crlfHeader(bytes), "", 16777216);
        const auto data = bytes.find("end_header\n") + 11;
        expectBox(replacedAll(bytes.substr(0, data), "\n", "\r") + bytes.substr(data), "", 16777216);
        // The same byte as the low byte of a little-endian short, and as an unsigned char.
        auto small = cube;
        for (auto& p : small.points) p.x = first + p.x;
        expectBox(binaryPly<std::int16_t, std::int32_t>(small, "short", "int"));
        expectBox(crlfHeader(binaryPly<std::int16_t, std::int32_t>(small, "short", "int")));
        expectBox(crlfHeader(binaryPly<std::uint8_t, std::uint8_t>(small, "uchar", "uchar")));
    }
    expectBox(crlfHeader(binaryPly<double, std::int32_t>(cube, "double", "int")));
    expectBox(replacedAll(ply(cube), "\n", "\r\n"));
    expectBox(replacedAll(ply(cube), "\n", "\r"));
}

// Comments, other properties (lists, too, and such that are no numbers) before and behind, the other name of the list of corners; other
// elements, told of.
TEST(ReadPly, OtherPropertiesAndElements)
{
    auto text = ply(cube);
    text = replaced(text, "property double x",
                    "comment of a program\nobj_info nothing\nproperty float nx\nproperty list uchar int neighbours\nproperty double x");
    text = replaced(text, "property list uint int vertex_indices",
                    "property uchar red\nproperty list uint int vertex_index\nproperty list uchar float texcoord");
    const auto data = text.find("end_header\n") + 11;
    std::string body;
    for (const auto& p : cube.points) body += fmt::format("nan 2 7 8 {} {} {}\n", p.x, p.y, p.z);
    for (const auto& f : cube.faces) body += fmt::format("255 {} {} 2 .5 +1\n", f.size(), fmt::join(f, " "));
    expectBox(text.substr(0, data) + body);
    const auto edges = replaced(ply(cube), "element face", "element edge 2\nproperty int vertex1\nproperty int vertex2\nelement face");
    expectBox(replaced(edges, faceRows(cube), "0 1\n1 2\n" + faceRows(cube)), "element \"edge\" (2 rows) left out");
    // Faces before vertices.
    const auto header = "ply\nformat ascii 1.0\nelement face 6\nproperty list uchar int vertex_indices\nelement vertex 8\n"
                        "property float x\nproperty float y\nproperty float z\nend_header\n";
    expectBox(header + faceRows(cube) + pointRows(cube));
}

// Strips of triangles, with -1 between them in one list: the four sides of the box, its floor, its lid, all turned inwards.
TEST(ReadPly, Strips)
{
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\n"
        "property list int int vertex_indices\nend_header\n";
    const Imported i("a.ply", header + pointRows(cube) + "20 0 4 1 5 2 6 3 7 0 4 -1 0 1 3 2 -1 4 7 5 6\n");
    EXPECT_EQ(i.refusal, "");
    EXPECT_EQ(i.mesh.triangles.size(), 12u);
    EXPECT_DOUBLE_EQ(i.volume(), -1);
    expectRefusal(header + pointRows(cube) + "3 0 -2 1\n", "line 18: tristrips 0 of 1 has the vertex -2, and there are 8");
    expectRefusal(header + pointRows(cube) + "3 0 -1 1\n", "it has no facets: its strips have fewer than three corners");
}

// Bytes behind the last row are told of. Each refusal says line or byte, what was found, and what was expected.
TEST(ReadPly, Refusals)
{
    const auto text = ply(cube), bytes = binaryPly<double, std::int32_t>(cube, "double", "int");
    expectBox(bytes + "more", "4 bytes behind the last row that the header tells of left out");
    expectRefusal(text + "more\n", "line 24: more rows than its header tells of");
    expectRefusal("plyx\n", "line 1: its header has the line \"plyx\"");
    expectRefusal("solid\n", "line 1: it does not begin with ply: this is no PLY file");
    expectRefusal(text.substr(0, 40), "line 4: it ends within its header: it is truncated");
    expectRefusal(replaced(text, "ascii", "binary_middle_endian"), "line 2: its header has the line \"format binary_middle_endian 1.0\"");
    expectRefusal(replaced(text, "double y", "doubly y"), "line 5: its header has the line \"property doubly y\"");
    expectRefusal(replaced(text, "double y", "double x"), "line 5: its header has the line \"property double x\"");
    expectRefusal(replaced(text, "double y", "double w"), "its vertices have no x, y and z");
    expectRefusal(replaced(text, "vertex_indices", "corners"), "its element face has no list vertex_indices");
    expectRefusal(replaced(text, "element face 6", "element face 0"), "it has no facets: its header tells of no element face");
    expectRefusal(replaced(text, "element face 6", "element nothing 4000000000"),
                  "line 7: its header has the line \"element nothing 4000000000\"");
    expectRefusal(replaced(text, "element face 6", "element nothing 2000000000\nelement face 6"),
                  "its header tells of 2000000000 rows of element \"nothing\" without a property");
    expectRefusal(replaced(text, "1 0 0\n", "1 nan 0\n"), "line 11: vertex 1 of 8 has a coordinate y that is no finite number");
    expectRefusal(replaced(text, "1 0 0\n", "1 x 0\n"), "line 11: vertex 1 of 8 is not whole: it is truncated or damaged");
    expectRefusal(replaced(text, "4 3 2 1 0", "4 3 2 1 9"), "line 18: face 0 of 6 has the vertex 9, and there are 8");
    expectRefusal(replaced(text, "4 3 2 1 0", "4 3 2 1 -1"), "line 18: face 0 of 6 has the vertex -1, and there are 8");
    expectRefusal(replaced(text, "4 3 2 1 0", "2 3 2"), "line 18: face 0 of 6 has 2 corners");
    expectRefusal(replaced(text, "4 3 2 1 0", "4 3 2 1 0 0"), "line 18: face 0 of 6 has more numbers than properties");
    expectRefusal(text.substr(0, text.size() - 10), "line 22: face 5 of 6 is not there: it is truncated");
    expectRefusal(bytes.substr(0, bytes.size() - 1), "byte 463: face 5 of 6 is not whole: it is truncated or damaged");
}

}
