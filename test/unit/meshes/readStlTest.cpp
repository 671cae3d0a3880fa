/// STL as programs write it. Each file is a box of 1 m3 with volume and facets to the last bit, its corners being numbers that single
/// precision holds.
#include "Imported.hpp"
#include <gtest/gtest.h>

namespace sph::test::readStlTest
{

namespace
{

void expectBox(const std::string& text, const std::string& regions = "body 12", const std::string& notes = "")
{
    const Imported i("a.stl", text);
    EXPECT_EQ(i.refusal, "") << text.substr(0, 200);
    EXPECT_EQ(i.volume(), 1) << text.substr(0, 200);
    EXPECT_EQ(i.regions(), regions);
    EXPECT_EQ(i.allNotes(), notes);
}

void expectRefusal(const std::string& text, const std::string& why) { EXPECT_EQ(Imported("a.stl", text).refusal, why); }

std::string inCapitals(std::string text)
{
    for (auto& c : text) c = char(std::toupper(c));
    return text;
}

}

// Keywords in any case, blanks and line ends of any kind, the two words of `end solid`, a byte-order mark, one line for all.
TEST(ReadStl, KeywordsAndBlanks)
{
    const auto text = solid(box());
    expectBox(inCapitals(text), "BODY 12");
    expectBox(replacedAll(replacedAll(text, "facet", "Facet"), "outer loop", "OUTER Loop"));
    expectBox("  \t" + replacedAll(text, "\n", "\n\t  "));
    expectBox(replacedAll(text, "\n", "\r\n"));
    expectBox(replacedAll(text, "\n", "\r"));
    expectBox(replacedAll(text, "\n", "\n\n"));
    expectBox(replacedAll(replacedAll(replacedAll(text, "endsolid", "end solid"), "endfacet", "end facet"), "endloop", "End Loop"));
    expectBox("\xEF\xBB\xBF" + text);
    auto line = replacedAll(text, "\n", " ");
    line.replace(line.find("solid body"), 11, "solid body\n");
    expectBox(line);
    expectBox(text.substr(0, text.rfind("body")));
}

// Normals that are none, or wrong, or missing: those of the corners' order count.
TEST(ReadStl, NormalsOfAnyKind)
{
    for (const auto* normal : {"normal nan nan nan", "normal -nan(ind) 1.#QNAN 0", "normal 1 0 0", "normal", "", "Normal 0,5 0,5 0"})
        expectBox(replacedAll(solid(box()), "normal 0 0 0", normal));
    auto bytes = binaryStl(box());
    for (std::size_t f = 0; f < 12; ++f)
        for (std::size_t k = 0; k < 12; ++k) bytes[84 + 50 * f + k] = '\xFF';
    expectBox(bytes, "patch0 12");
}

// A number may begin with a point or a plus, and have an exponent.
TEST(ReadStl, Numbers)
{
    const Imported i("a.stl", replacedAll(replacedAll(solid(box({0, 0, 0}, {0.5, 1, 2})), " 0.5", " +.5"), " 2", " 2.e+0"));
    EXPECT_EQ(i.volume(), 1) << i.refusal;
}

// A region for the solids of one name, which is all of the line; one without a name is patch0, one without facets none.
TEST(ReadStl, Solids)
{
    const auto m = box();
    expectBox(solid(m, "the lid 1", 0, 2) + solid(m, "the lid 2", 2), "the_lid_1 2, the_lid_2 10",
              "region \"the lid 1\" is called the_lid_1\nregion \"the lid 2\" is called the_lid_2");
    expectBox(solid(m, "a", 0, 2) + solid(m, "b", 2, 4) + solid(m, "a", 4), "a 10, b 2");
    expectBox(solid(m, "", 0, 2) + solid(m, "empty", 0, 0) + solid(m, "shell", 2), "patch0 2, shell 10");
}

// What begins with "solid" is binary where its length or a zero says so; colours do not matter; bytes behind the facets are told of.
TEST(ReadStl, Binary)
{
    const auto bytes = binaryStl(box());
    const auto headed = [&](const std::string& header) { return header + bytes.substr(header.size()); };
    expectBox(headed("solid body made by a program"), "patch0 12");
    expectBox(headed("solid body made by a program") + "xx", "patch0 12", "2 bytes behind the 12 facets that the header tells of left out");
    expectBox(bytes + std::string(60, '\0'), "patch0 12",
              "60 bytes behind the 12 facets that the header tells of left out: 1 facet have as many");
    auto coloured = headed("COLOR=\x80\x40\x20\xFF,MATERIAL=");
    for (std::size_t f = 0; f < 12; ++f) coloured.replace(84 + 50 * f + 48, 2, "\xFF\xFF");
    expectBox(coloured, "patch0 12");
}

// Each refusal says where, what was expected, and what was found.
TEST(ReadStl, Refusals)
{
    const auto text = solid(box()), bytes = binaryStl(box());
    expectRefusal(replaced(text, "vertex 1 1 0", "vertex 1 nan 0"), "line 6: the coordinate \"nan\" is no finite number");
    expectRefusal(replaced(text, "vertex 1 1 0", "vertex 1,5 1 0"),
                  "line 6: the coordinate \"1,5\" is no finite number: decimals need a point");
    expectRefusal(replaced(text, "vertex 1 1 0", "vertex 1 1"), "line 6: expected three coordinates, and the line ends");
    expectRefusal(replaced(text, "vertex 1 1 0", "vertx 1 1 0"), "line 6: facet 0: expected a vertex, found \"vertx\"");
    expectRefusal(replaced(text, " endloop", "vertex 0 0 0\n endloop"),
                  "line 7: facet 0: expected endloop after three vertices, found \"vertex\"");
    expectRefusal(replaced(text, "endfacet\n", ""), "line 8: facet 0: expected endfacet, found \"facet\"");
    expectRefusal(text + "facet", "line 87: expected solid or the end, found \"facet\"");
    expectRefusal(text.substr(0, text.rfind("endsolid")), "line 85: it ends within solid \"body\", without endsolid: it is truncated");
    expectRefusal(text.substr(0, text.rfind("endloop")),
                  "line 84: it ends within facet 11, where endloop after three vertices was expected: it is truncated");
    expectRefusal("hello\n", "line 1: expected solid, found \"hello\": this is no STL file");
    expectRefusal(std::string("\xFF\xFEs\0o\0", 6), "it is text in UTF-16: save it in UTF-8 or ASCII");
    expectRefusal(bytes.substr(0, 500), "byte 500: its header tells of 12 facets, 8 are there: it is truncated");
    expectRefusal(bytes.substr(0, 80) + std::string(4, '\0') + bytes.substr(84),
                  "byte 80: its header tells of no facets, and 600 bytes follow, as 12 facets have");
    auto damaged = bytes;
    damaged.replace(84 + 50 + 12 + 4, 4, "\xFF\xFF\xFF\xFF");
    expectRefusal(damaged, "byte 150: facet 1 has a coordinate that is no finite number");
}

}
