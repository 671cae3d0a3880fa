#include "Parsed.hpp"
#include "dictionary/DictionaryText.hpp"
#include <fstream>
#include <sstream>
#include <unistd.h>

using namespace sph;

namespace
{

const std::filesystem::path folder = std::filesystem::temp_directory_path() / ("sphEditingTest." + std::to_string(::getpid()));

std::string read(const std::string& file)
{
    std::ostringstream text;
    text << std::ifstream(folder / file).rdbuf();
    return text.str();
}

void write(const std::string& file, const std::string& text)
{
    std::filesystem::create_directories(folder);
    std::ofstream(folder / file) << text;
}

/// The text of a dictionary after an edit, or the message that refused it.
template<class Edit> std::string after(const std::string& text, const Edit& edit)
{
    write("d", text);
    std::string result;
    try
    {
        edit();
        result = read("d");
    }
    catch (const CaseError& e)
    {
        EXPECT_EQ(read("d"), text) << "a refused edit changes nothing";
        result = e.what();
    }
    std::filesystem::remove_all(folder);
    return result;
}

std::string edited(const std::string& text, const std::string& entry, const std::string& value)
{
    return after(text, [&] { setEntry(folder, "d", entry, value); });
}

std::string without(const std::string& text, const std::string& entry)
{
    return after(text, [&] { removeEntry(folder, "d", entry); });
}

}

// An edit changes the value and no other character: comments, blanks, macros and line ends stay.
TEST(DictionaryEditing, changesTheValueAlone)
{
    const std::string text = "// head\nL 1e-3; // length\r\ndeltaT\t$L ; /* keep */ s { a (1\n 2); \"b.*\" #eval{ 2*$L }; in { } }\n";
    const auto with = [&](std::string from, const std::string& to)
    {
        auto changed = text;
        return changed.replace(changed.find(from), from.size(), to);
    };
    EXPECT_EQ(edited(text, "L", "2e-3"), with("1e-3", "2e-3"));
    EXPECT_EQ(edited(text, "deltaT", "-5"), with("$L ", "-5 "));
    EXPECT_EQ(edited(text, "s.a", "3{7}"), with("(1\n 2)", "3{7}"));
    EXPECT_EQ(edited(text, "s/b.*", "$L"), with("#eval{ 2*$L }", "$L"));
    EXPECT_EQ(edited(text, ":s:in", "{ x 1; }"), with("{ }", "{ x 1; }"));
}

// A missing entry is added at the end of its dictionary, in front of the closing line of OpenFOAM's files.
TEST(DictionaryEditing, addsWhatIsMissing)
{
    EXPECT_EQ(edited("a 1;\n\n// ***** //\n", "bb", "2"), "a 1;\n\nbb              2;\n// ***** //\n");
    EXPECT_EQ(edited("a 1;\n", "b", "2"), "a 1;\nb               2;\n");
    EXPECT_EQ(edited("s\n{\n    a 1;\n}\n", "s.b", "2"), "s\n{\n    a 1;\n    b               2;\n}\n");
    EXPECT_EQ(edited("s { a 1; }\n", "s.b", "2"), "s { a 1;  b               2; }\n");
    EXPECT_EQ(edited("a 1;\n", "s.b", "2"), "d: there is no dictionary \"s\" to add \"b\" to");
}

// Of a keyword given twice the one that counts is set.
TEST(DictionaryEditing, setsTheDefinitionThatCounts)
{
    EXPECT_EQ(edited("a 1;\ns { x 1; }\na 2;\ns { x 3; }\n", "a", "9"), "a 1;\ns { x 1; }\na 9;\ns { x 3; }\n");
    EXPECT_EQ(edited("a 1;\ns { x 1; }\na 2;\ns { x 3; }\n", "s.x", "9"), "a 1;\ns { x 1; }\na 2;\ns { x 9; }\n");
    EXPECT_EQ(edited("base { v 1; }\np { $base; v 2; }\n", "p.v", "9"), "base { v 1; }\np { $base; v 9; }\n");
}

// An entry goes with its line where it has one to itself, and with each of its definitions.
TEST(DictionaryEditing, removesAnEntry)
{
    EXPECT_EQ(without("a 1;\n  b 2;\nc 3;\n", "b"), "a 1;\nc 3;\n");
    EXPECT_EQ(without("a 1; b 2; // both\n", "b"), "a 1;  // both\n");
    EXPECT_EQ(without("s\n{\n    x { y 1; }\n    z 2;\n}\n", "s.x"), "s\n{\n    z 2;\n}\n");
    EXPECT_EQ(without("s { x (1\n 2); }\n", "s.x"), "s {  }\n");
    EXPECT_EQ(without("a 1;\nb 2;\na 3;\n", "a"), "b 2;\n");
    EXPECT_EQ(without("\"p.*\" 1;\nq 2;\n", "p.*"), "q 2;\n");
    EXPECT_EQ(without("a 1;\nab 2;\n", "b"), "d: there is no entry \"b\". Known entries: a, ab.");
    EXPECT_EQ(without("\"p.*\" 1;\n", "pq"), "d: \"pq\" is given by a pattern, which stays");
    EXPECT_EQ(without("a 1;\nb $a;\n", "a"), "d:1: \"$a\" is neither an entry that is defined above nor an environment variable");
    EXPECT_EQ(without("base { v 1; }\np { $base; }\n", "p.v").find("d:1: \"v\" of \"p.v\" stands here, where"), 0u);
}

// What would change another entry, or break the file, is refused, and nothing is written.
TEST(DictionaryEditing, refusesWhatWouldHarm)
{
    EXPECT_EQ(edited("base { v 1; }\np { $base; }\n", "p.v", "2"),
              "d:1: \"v\" of \"p.v\" stands here, where changing it would change more than this entry; give it a line of its own "
              "in \"d\" "
              "first");
    EXPECT_EQ(edited("a 1;\n", "a", "1; b 2"),
              "\"1; b 2\" cannot be the value of an entry: brackets and quotes must be balanced, without ';' behind it");
    for (const auto* value : {"(1 2", "\"x", "}", "{ a 1;", "1 // x", "/*"})
        EXPECT_EQ(edited("a 1;\n", "a", value)
                      .find("With \"" + std::string(value) + "\" for \"a\" the file would be unreadable and is left as it is:\nd:1: "),
                  0u)
            << value << edited("a 1;\n", "a", value);
    EXPECT_EQ(edited("a 1;\nb (2;\n", "a", "2"), "d:2: the '(' of \"b\" is never closed");
}

// What the edit would make is read before it is written: macros and keywords that are none are known by that alone.
TEST(DictionaryEditing, refusesWhatCouldNotBeRead)
{
    const std::string text = "FoamFile { class dictionary; }\na 1;\ns { x 1; }\n";
    const auto with = [](const std::string& value, const std::string& entry)
    { return "With \"" + value + "\" for \"" + entry + "\" the file would be unreadable and is left as it is:\nd:"; };
    EXPECT_EQ(edited(text, "a", "$nope"),
              with("$nope", "a") + "2: \"$nope\" is neither an entry that is defined above nor an environment variable");
    EXPECT_EQ(edited(text, "a", "{ $nope; }").find(with("{ $nope; }", "a")), 0u);
    EXPECT_EQ(edited(text, "a", "$s").find(with("$s", "a")), 0u);
    EXPECT_EQ(edited(text, "b", "#eval{ 1/$nope }").find(with("#eval{ 1/$nope }", "b")), 0u);
    for (const auto* keyword : {"3", "(U|p)", "}", "#include", "$a", "#{", "b;c", "a b", "b {"})
        EXPECT_NE(edited(text, keyword, "1").find("\"" + std::string(keyword) + "\""), std::string::npos) << keyword;
    EXPECT_EQ(edited(text, "FoamFile", "1"), "d:1: the header FoamFile is a dictionary");
    // Every value that can be read is written: a value for a dictionary has its own ';'.
    EXPECT_EQ(edited(text, "s", "5"), "FoamFile { class dictionary; }\na 1;\ns 5;\n");
    EXPECT_EQ(edited(text, "a", "{ y $s.x; }").find("With"), 0u) << "s comes behind a";
    EXPECT_EQ(edited(text, "s.x", "{ y $a; }"), "FoamFile { class dictionary; }\na 1;\ns { x { y $a; }; }\n");
    EXPECT_EQ(edited(text, "s.x", "#eval{ 1/$a }"), "FoamFile { class dictionary; }\na 1;\ns { x #eval{ 1/$a }; }\n");
    EXPECT_EQ(edited(text, "FoamFile.class", "word"), "FoamFile { class word; }\na 1;\ns { x 1; }\n");
}

// Values and entries print in foamDictionary's layout, numbers with all the digits that were written.
TEST(DictionaryEditing, printsLikeFoamDictionary)
{
    const Parsed p("L 1.23456789e-3;\ng (0 -9.81 0);\nx $L;\ns { \"p.*\" \"a b\"; nu [m^2/s] 1; }\nl ({ a 1; });\n");
    EXPECT_EQ(valueText(p.dict, "x"), "1.23456789e-3");
    EXPECT_EQ(valueText(p.dict, "g"), "(0 -9.81 0)");
    EXPECT_EQ(valueText(p.dict, "s.pressure"), "\"a b\"");
    EXPECT_EQ(entryText(p.dict, "s"), "s\n{\n    \"p.*\"           \"a b\";\n    nu              [m^2/s] 1;\n}\n");
    EXPECT_EQ(keywords(p.dict, "s"), (std::vector<std::string>{"\"p.*\"", "nu"}));
    const Parsed again(entryText(p.dict, ""));
    EXPECT_EQ(again.errors(), "");
    EXPECT_EQ(again.dict.dictionaries("l")[0].get<int>("a"), 1);
    EXPECT_EQ(entryText(again.dict, ""), entryText(p.dict, "")) << "what is printed reads back as the same";
    EXPECT_THROW(valueText(p.dict, "s.nu2"), CaseError);
}
