/// OFF as programs write it. Each file is a box of 1 m3 with faces of four corners.
#include "Imported.hpp"
#include <gtest/gtest.h>

namespace sph::test::readOffTest
{

namespace
{

const PolygonMesh cube = prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);

void expectBox(const std::string& text)
{
    const Imported i("a.off", text);
    EXPECT_EQ(i.refusal, "") << text;
    EXPECT_DOUBLE_EQ(i.volume(), 1);
    EXPECT_EQ(i.regions(), "patch0 12");
}

void expectRefusal(const std::string& text, const std::string& why) { EXPECT_EQ(Imported("a.off", text).refusal, why); }

}

// Counts in the line of the keyword or without the edges; comments; colours and normals, which do not matter; numbers and line ends of
// any kind.
TEST(ReadOff, AsProgramsWriteIt)
{
    const auto text = off(cube);
    expectBox(text);
    expectBox(replaced(text, "OFF\n8 6 0", "OFF 8 6 0"));
    expectBox(replaced(text, "8 6 0", "8 6"));
    expectBox("# of a program\n\n" + replacedAll(text, "\n", " # here\n\n"));
    expectBox(replacedAll(text, "\n", "\r\n"));
    expectBox(replacedAll(text, "1 0 0\n", "+1. .0 0e5\n"));
    expectBox(replaced(replacedAll(text, " 0\n", " 0 255 0 0 255\n"), "8 6 0 255 0 0 255", "8 6 0"));
    expectBox(replaced(text, "OFF", "STCNOFF"));
    expectBox("\xEF\xBB\xBF" + text);
}

// Each refusal says the line, what was found, and what was expected.
TEST(ReadOff, Refusals)
{
    const auto text = off(cube);
    expectRefusal("hello", "line 1: it does not begin with OFF, but with \"hello\": this is no OFF file");
    expectRefusal(replaced(text, "OFF", "4OFF"), "line 1: \"4OFF\": vertices of other than three coordinates are not read");
    expectRefusal(replaced(text, "OFF", "XOFF"), "line 1: \"XOFF\" is no OFF that is known");
    expectRefusal(replaced(text, "OFF", "OFF BINARY"), "line 1: a binary OFF is not read: write it as text");
    expectRefusal("OFF\n", "line 1: it ends within its header: it is truncated");
    expectRefusal(replaced(text, "8 6 0", "8 x 0"), "line 2: expected the numbers of vertices and facets, found \"x\"");
    expectRefusal(replaced(text, "8 6 0", "8 0 0"), "it has no facets");
    expectRefusal(replaced(text, "8 6 0", "8 5 0"),
                  "line 16: its header tells of 8 vertices and 5 facets, and more follows: \"4 3 0 4 7\"");
    expectRefusal(replaced(text, "8 6 0", "8 7 0"),
                  "line 16: its header tells of 8 vertices and 7 facets, but it ends after 6 facets: it is truncated");
    expectRefusal(replaced(text, "1 0 0", "1 0 nan"), "line 4: the coordinate \"nan\" is no finite number");
    expectRefusal(replaced(text, "4 3 2 1 0", "4 3 2 1 8"), "line 11: facet 0 of 6 has the vertex \"8\", and there are 8");
    expectRefusal(replaced(text, "4 3 2 1 0", "4 3 2 1"), "line 11: facet 0 of 6 has the vertex \"\", and there are 8");
    expectRefusal(replaced(text, "4 3 2 1 0", "2 3 2"), "line 11: facet 0 of 6 has 2 corners");
    expectRefusal(text.substr(0, 20), "line 4: expected three coordinates, and the line ends");
}

}
