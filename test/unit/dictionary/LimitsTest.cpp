// What is nested, repeated or endless beyond reason ends in an error that names the limit and the line, before the stack, the memory or ten
// seconds are spent. Each of these once ended a program by a signal, or not at all.
#include "Parsed.hpp"
#include "dictionary/KeywordPattern.hpp"
#include "dictionary/positionExpression.hpp"
#include <chrono>
#include <fstream>
#include <sys/stat.h>
#include <unistd.h>

using namespace sph;

namespace
{

constexpr int many = 10'000;

std::string repeated(const std::string& text, int n)
{
    std::string all;
    for (int k = 0; k < n; ++k) all += text;
    return all;
}

void expectError(const std::string& text, const std::string& words)
{
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_NE(Parsed(text).errors().find(words), std::string::npos)
        << text.substr(0, 60) << "...: " << Parsed(text).errors().substr(0, 500);
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10)) << text.substr(0, 60);
}

}

TEST(DictionaryLimits, nesting)
{
    const std::string deeper = "dictionaries nest deeper than 100 levels: nothing behind this is read";
    EXPECT_EQ(Parsed(repeated("a {", 99) + repeated("}", 99)).errors(), "");
    for (const auto& closed : {repeated("}", many), std::string()})
        expectError(repeated("a\n{\n", many) + closed, "constant/d:200: " + deeper);
    expectError("l (" + repeated("{ a (", many) + repeated("); }", many) + ");", deeper);
    expectError("l " + repeated("x { y ", many) + repeated("; }", many) + ";", deeper);
    // Macros put what is nested into one another: each dictionary here is 60 levels deeper than the one before.
    std::string macros = "d0 { x 1; }\n";
    for (int k = 1; k < 10; ++k)
        macros += "d" + std::to_string(k) + " " + repeated("{ a ", 60) + "{ $:d" + std::to_string(k - 1) + "; }" + repeated("}", 60) + "\n";
    expectError(macros, "constant/d:3: " + deeper);
    macros = "d0 ({ x 1; });\n";
    for (int k = 1; k < 200; ++k) macros += "d" + std::to_string(k) + " ({ x $d" + std::to_string(k - 1) + "; });\n";
    expectError(macros, "constant/d:100: " + deeper);
}

TEST(DictionaryLimits, bracketsOfListsAreReadHoweverManyThereAre)
{
    const Parsed p("a " + repeated("(", many) + "1" + repeated(")", many) + ";\nb 2;\n");
    EXPECT_EQ(p.dict.get<int>("b"), 2);
    EXPECT_EQ(p.errors(), "");
    p.dict.get<std::vector<std::vector<double>>>("a");
    EXPECT_NE(p.errors(), "");
    expectError("a " + repeated("(", many) + ";\n", "constant/d:1: the '(' of \"a\" is never closed");
    expectError(repeated("w(", many) + "\n", "nothing behind this is read");
    expectError("a [" + repeated("(", many) + "];\nb { $a; }\n", "constant/d:2");
    const Parsed units("a [" + repeated("(", many) + "] 1;\n");
    units.dict.get("a", units::m);
    EXPECT_EQ(units.errors(), "constant/d:1: \"a\" has wrong dimensions: the text in the brackets is longer than 200 characters");
}

TEST(DictionaryLimits, expressions)
{
    const std::string deeper = "brackets, signs and conditions nest deeper than 100 levels";
    for (const std::string open : {"(", "-", "!", "2^", "sqrt(", "1 ? 1 : ", "1 ? "})
    {
        expectError("x 1;\na #eval{ " + repeated(open, many) + "1 };\n", "constant/d:2: #eval");
        expectError("x 1;\na #eval{ " + repeated(open, many) + "1 };\n", deeper);
    }
    EXPECT_EQ(Parsed("a #eval{ " + repeated("(", 90) + "1" + repeated(")", 90) + " };\n").dict.get<double>("a"), 1);
    EXPECT_THROW(evaluateAt(repeated("(", many), anyPlace), ExpressionError);
}

TEST(DictionaryLimits, macrosThatDouble)
{
    const std::string tooMany = "more than 2000000 words, with what macros and included files bring in: nothing behind this is read";
    std::string values = "b0 x;\n", blocks = "b0 { x 1; }\n";
    for (int k = 1; k < 60; ++k)
    {
        const auto before = "$b" + std::to_string(k - 1);
        values += "b" + std::to_string(k) + " " + before + " " + before + ";\n";
        blocks += "b" + std::to_string(k) + " { p { " + before + "; } q { " + before + "; } }\n";
    }
    expectError(values, tooMany);
    expectError(blocks, tooMany);
    expectError("a (" + repeated("1 ", 2'100'000) + ");\n", tooMany);
}

// A search that tries all ways one after the other takes 2^n steps for the first of these; one that counts repetitions out takes the second's
// memory; each step of the third is a call within a call.
TEST(DictionaryLimits, regularExpressions)
{
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_FALSE(KeywordPattern("(a|aa)+b").matches(repeated("a", 500)));
    EXPECT_TRUE(KeywordPattern("(a|aa)+b").matches(repeated("a", 499) + "b"));
    EXPECT_FALSE(KeywordPattern("(x+x+)+y").matches(repeated("x", 500)));
    EXPECT_FALSE(KeywordPattern(".*").matches(repeated("a", 100'000))) << "longer than any keyword";
    EXPECT_TRUE(KeywordPattern("proc[0-9]{2}").matches("proc07"));
    EXPECT_TRUE(KeywordPattern(repeated("(a|b)?", 80)).matches("abba"));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(5));

    const std::string tooLong = "is too long for a regular expression: at most 500 characters, repetitions written out";
    for (const auto& pattern :
         {repeated("(", many), repeated("a?", many), std::string("((((a{1,99}){1,99}){99}){99,}){99}"), std::string("(a?){30000}")})
    {
        expectError("x 1;\n\"" + pattern + "\" 1;\n", "constant/d:2: ");
        expectError("x 1;\n\"" + pattern + "\" 1;\n", tooLong);
        expectError("x 1;\n#remove (\"" + pattern + "\")\n", tooLong);
    }
    expectError("\"(\" 1;\n", "constant/d:1: \"(\" is not a valid regular expression");

    // Patterns within one another, and a name that can be divided between them in countless ways.
    const Parsed p(repeated("\".*\" { ", 40) + "x 1;" + repeated(" }", 40) + "\na $" + repeated("b.", 80) + "b;\n");
    EXPECT_NE(p.errors(), "");
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

// Many entries are found without looking at each.
TEST(DictionaryLimits, entries)
{
    std::string text;
    for (int k = 0; k < 100'000; ++k) text += "entry" + std::to_string(k) + " 1;\n";
    for (int k = 0; k < 100'000; ++k) text += "again" + std::to_string(k) + " $entry" + std::to_string(k) + ";\n";
    const auto begin = std::chrono::steady_clock::now();
    const Parsed p(text + "#remove entry0\n\"e.*\" 2;\n\"f.*\" 3;\n\"e.*\" 4;\n");
    EXPECT_EQ(p.dict.get<int>("again99999"), 1);
    EXPECT_EQ(p.dict.get<int>("entry1"), 1);
    EXPECT_EQ(p.dict.get<int>("entry0"), 4);
    EXPECT_EQ(p.errors(), "");
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

// Endless mistakes are told up to the hundredth.
TEST(DictionaryLimits, mistakes)
{
    for (const auto* mistake : {"3 4;\n", "]\n", "\"\n", "$x;\n", "x$y 1;\n", "a 1)\n;\n", "}\n", "# ;\n", "a(\n"})
        expectError(repeated(mistake, 100'000), "mistakes until here: nothing behind this is read");
    expectError("a\n" + repeated(")\n", 100'000) + ";\n", "100 mistakes until here: nothing behind this is read");
}

// Only regular files are read: a pipe waits for a writer that may never come, and a device may have no end.
TEST(DictionaryLimits, filesThatAreNone)
{
    const auto folder = std::filesystem::temp_directory_path() / ("sphLimitsTest." + std::to_string(::getpid()));
    std::filesystem::create_directories(folder / "folder");
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    std::ofstream(folder / "large") << "a 1;\n";
    std::filesystem::resize_file(folder / "large", (64u << 20) + 1);
    for (int k = 0; k < 150; ++k) std::ofstream(folder / ("chain" + std::to_string(k))) << "#include \"chain" << k + 1 << "\"\n";
    for (int k = 0; k < 40; ++k)
        std::ofstream(folder / ("twice" + std::to_string(k)))
            << "#include \"twice" << k + 1 << "\"\n#include \"twice" << k + 1 << "\"\na 1;\n";
    std::ofstream(folder / "twice40") << "b 2;\n";

    const auto said = [&](const std::string& file)
    {
        const auto diagnostics = std::make_shared<Diagnostics>();
        Dictionary::read(folder, file, diagnostics);
        try
        {
            diagnostics->throwIfAny();
        }
        catch (const CaseError& e)
        {
            return std::string(e.what());
        }
        return std::string();
    };
    const std::string device = "this is a device or a pipe: only regular files are read";
    EXPECT_EQ(said("pipe"), "pipe: " + device);
    EXPECT_EQ(said("/dev/zero"), "/dev/zero: " + device);
    EXPECT_EQ(said("folder"), "folder: this is a folder");
    EXPECT_EQ(said("large"), "large: this file has 64 MB; at most 64 MB of text are read");
    std::ofstream(folder / "d") << "a 1;\n#include \"pipe\"\n#include \"/dev/zero\"\n#sinclude \"pipe\"\n#include \""
                                << repeated("long", 100) << "\"\n";
    EXPECT_EQ(said("d").substr(0, said("d").find("d:5")), "d:2: \"pipe\" cannot be included: " + device +
                                                              "\nd:3: \"/dev/zero\" cannot be included: " + device +
                                                              "\nd:4: \"pipe\" cannot be included: " + device + "\n");
    EXPECT_EQ(said("chain0"), "chain100:1: dictionaries nest deeper than 100 levels: nothing behind this is read");
    EXPECT_NE(said("twice0").find("more than 1000 files are included: nothing behind this is read"), std::string::npos) << said("twice0");
    std::filesystem::remove_all(folder);
}
