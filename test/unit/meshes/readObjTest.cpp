/// OBJ as programs write it. Each file is a box of 1 m3.
#include "Imported.hpp"
#include <gtest/gtest.h>

namespace sph::test::readObjTest
{

namespace
{

void expectBox(const std::string& text, const std::string& regions = "patch0 12", const std::string& notes = "")
{
    const Imported i("a.obj", text);
    EXPECT_EQ(i.refusal, "") << text;
    EXPECT_DOUBLE_EQ(i.volume(), 1) << text;
    EXPECT_EQ(i.regions(), regions) << text;
    EXPECT_EQ(i.allNotes(), notes);
}

void expectRefusal(const std::string& text, const std::string& why) { EXPECT_EQ(Imported("a.obj", text).refusal, why); }

/// Facets of three corners.
std::string vertices(const Mesh& m = box()) { return rows({m.points, {}}, "v ", "", 0); }
std::string faces(std::size_t from = 0, std::size_t to = 12)
{
    const auto m = box();
    std::string text;
    for (auto f = from; f < to; ++f)
        text += fmt::format("f {} {} {}\n", m.triangles[f][0] + 1, m.triangles[f][1] + 1, m.triangles[f][2] + 1);
    return text;
}

}

// The name of the latest g or o is the region; one that comes again goes on, and one without faces is none. Materials make none, known or
// not.
TEST(ReadObj, GroupsObjectsAndMaterials)
{
    expectBox(vertices() + faces());
    expectBox("mtllib missing.mtl\n" + vertices() + "usemtl a\n" + faces(0, 5) + "usemtl b\n" + faces(5));
    expectBox("mtllib missing.mtl\no body\n" + vertices() + "usemtl a\n" + faces(0, 5) + "usemtl b\n" + faces(5), "body 12");
    expectBox("g\ng lid\n" + vertices() + "usemtl a\n" + faces(0, 2) + "g shell\nusemtl a\n" + faces(2, 4) + "usemtl b\n" + faces(4),
              "lid 2, shell 10");
    expectBox("o body\n" + vertices() + "g lid\n" + faces(0, 2) + "g none\ng shell\n" + faces(2, 6) + "g lid\n" + faces(6),
              "lid 8, shell 4");
    expectBox("o lid\n" + vertices() + faces(0, 2) + "s 1\no shell of#1 # a comment\n" + faces(2), "lid 2, shell_of_1 10",
              "region \"shell of#1\" is called shell_of_1");
    expectBox(vertices() + faces(0, 2) + "g default\n" + faces(2), "patch0 2, default 10");
}

// .2 for 0.2, +1, exponents; colours and weights behind the coordinates; a byte-order mark; line ends of any kind.
TEST(ReadObj, NumbersAndLineEnds)
{
    const auto text = vertices(box({0, 0, 0}, {0.2, 5, 1})) + faces();
    expectBox(text);
    expectBox(replacedAll(text, " 0.2", " .2"));
    expectBox(replacedAll(replacedAll(vertices(box({0, 0, 0}, {0.2, 5, 1})), "0.2 ", "+2.0E-1 "), " 5 ", " +500e-2 ") + faces());
    expectBox(replacedAll(text, "v 0 ", "v  -0.\t"));
    expectBox(replacedAll(text, " 0\n", " 0 1.0\n"));
    expectBox(replacedAll(text, " 1\n", " 1 0.5 0.25 1 1\n"));
    expectBox("\xEF\xBB\xBF" + text);
    expectBox(replacedAll(text, "\n", "\r\n"));
    expectBox(replacedAll(text, "\n", "\r"));
    expectBox(text.substr(0, text.size() - 1));
    // Too small for a double is 0.
    expectBox(replacedAll(text, "v 0 ", "v 1e-999 "));
}

// Comments behind anything, lines that go on, also within a comment's end, vertices counted back, textures and normals that are not
// there, faces before vertices.
TEST(ReadObj, Faces)
{
    const auto text = vertices() + faces();
    expectBox(replacedAll(text, "\n", " # a comment \\\n"));
    expectBox(replacedAll(text, "\n", "# a comment\n"));
    expectBox(replacedAll(replacedAll(text, "f ", "f \\\n "), " 1\n", " \\  \n 1\n"));
    expectBox(replacedAll(replacedAll(text, "f ", "f \\\r\n "), " 1\n", " 1\r\n"));
    const auto m = box();
    std::string back = vertices();
    for (const auto& [a, b, c] : m.triangles) back += fmt::format("f {} {} {}\n", a - 8, b - 8, c - 8);
    expectBox(back);
    std::string full = vertices();
    for (const auto& [a, b, c] : m.triangles) full += fmt::format("f {}/99/-99 {}//77 {}/5\n", a + 1, b + 1, c + 1);
    expectBox(full);
    expectBox(faces() + vertices());
    expectBox("vt 0 0\nvn nan 0 0\nvp 1\ns off\nlod 1\n" + text);
    expectBox(text + "l 1 2 3\np 1\nf 1 2\n", "patch0 12",
              "1 face of fewer than three corners left out\n1 line (l) left out\n1 point element (p) left out");
}

// Each refusal says the line, what was found, and what was expected.
TEST(ReadObj, Refusals)
{
    const auto text = vertices() + faces();
    expectRefusal(replaced(text, "f 1 3 4", "f 1 3 9"), "line 9: the face has the vertex 9, and there are 8");
    expectRefusal(replaced(text, "f 1 3 4", "f 1 3 -9"),
                  "line 9: the face has the vertex -9, and 8 stand before it: the first is 1, the last -1");
    expectRefusal(replaced(text, "f 1 3 4", "f 1 3 0"),
                  "line 9: the face has the vertex 0, and 8 stand before it: the first is 1, the last -1");
    expectRefusal(replaced(text, "f 1 3 4", "f 1 3 4.5"), "line 9: expected the number of a vertex, as 7, 7/2/3 or -1, found \"4.5\"");
    expectRefusal(replaced(text, "f 1 3 4", "f 1 3 99999999999999999999"),
                  "line 9: expected the number of a vertex, as 7, 7/2/3 or -1, found \"99999999999999999999\"");
    expectRefusal(replaced(text, "v 1 0 0", "v 1 0"), "line 2: expected three coordinates, and the line ends");
    expectRefusal(replaced(text, "v 1 0 0", "v 1 0,5 0"), "line 2: the coordinate \"0,5\" is no finite number: decimals need a point");
    expectRefusal(replaced(text, "v 1 0 0", "v 1 0 1e999"), "line 2: the coordinate \"1e999\" is no finite number");
    expectRefusal(replaced(text, "v 1 0 0", "v 1 0 0 red"), "line 2: expected nothing but numbers behind the coordinates, found \"red\"");
    expectRefusal(replaced(text, "v 1 0 0", "w 1 0 0"), "line 2: \"w\" is no statement of an OBJ file");
    expectRefusal(text + "surf 0 1 0 1 1 2 3\n", "line 21: \"surf\" is not read: export the surface as polygons");
    expectRefusal(text + "f 1 2 3 \\", "line 21: the file ends with a backslash, which goes on with a next line: it is truncated");
    expectRefusal("solid a\n", "line 1: \"solid\" is no statement of an OBJ file: this is no OBJ file");
    expectRefusal("# nothing\n", "it has no vertices: this is no OBJ file");
    expectRefusal(vertices(), "it has no facets");
    expectRefusal(std::string("\xFF\xFEv\0", 4), "it is text in UTF-16: save it in UTF-8 or ASCII");
}

}
