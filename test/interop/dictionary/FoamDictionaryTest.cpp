#include "dictionary/Dictionary.hpp"
#include "dictionary/DictionaryText.hpp"
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <unistd.h>

using namespace sph;

namespace
{

const std::string sample = R"(FoamFile { version 2.0; format ascii; class dictionary; object sample; }
L 1e-3; // length
word foo<bar>:baz.q; text "a; b \"c\""; number -1.5e-3; dotted 1.; switch off;
g (0 -9.81 0); list 3(1 2 3); uniformList 5{0.5}; typed List<scalar> 3(1 2 3); words (a b "c.*");
nu [0 2 -1 0 0 0 0] 1e-6; named nu [0 2 -1 0 0 0 0] 1e-6;
field nonuniform List<vector> 2((0 0 0) (1 2 3)); nested ((1 2)(3 4)); none ();
div(phi,U) Gauss linearUpwind grad(U);
long
    one two;
base { type wall; v 1; }
sub { a 1; L 2e-3; b $a; c $L; d $..L; e $:base.v; in { z $..a; top $...L; alt ${..L}; up $a; } }
copy { $base; v 2; }
copyAfter { v 2; ${base} }
expression #eval "2.0*$L + 1"; braces #eval{ sqrt(2) }; degrees #eval{ sin(degToRad(30)) };
#ifeq $L 1e-3
chosen yes;
#else
chosen no;
#endif
#if 0
branch 1;
#elif 1
branch 2;
#endif
"p.*" { type other; }
"(inlet|outlet).*" { type patch; }
inletA { type exact; }
"r.*" 1; "rs.*" 2; "r.*" 3;
twice 1; twice 2; blocks { x 1; } blocks { y 2; }
#inputMode protect
twice 3;
#inputMode merge
#default twice 4;
#default fresh 5;
removed 1;
#remove removed
patches ( "(walls|cyc).*" { type rebound; } outlet { type escape; } );
#include "included"
place parts;
#include "$FOAM_CASE/${place}/environment"
inCase { #include "<case>/parts/environment"
}
#include "./parts/ofCase"
)";

/// Every value that the sample gives, and keywords that a pattern answers.
const std::vector<std::string> entries{
    "L",           "word",      "text",        "number",      "dotted",          "switch",     "g",           "list",
    "uniformList", "typed",     "words",       "nu",          "named",           "field",      "nested",      "none",
    "div(phi,U)",  "long",      "sub.b",       "sub.c",       "sub.d",           "sub.e",      "sub.in.z",    "sub.in.top",
    "sub.in.alt",  "sub.in.up", "copy.type",   "copy.v",      "copyAfter.v",     "expression", "braces",      "degrees",
    "chosen",      "branch",    "pX.type",     "inletA.type", "inletB.type",     "rst",        "twice",       "blocks.x",
    "blocks.y",    "fresh",     "fromInclude", "patches",     "FoamFile.object", "deep",       "inCase.deep", "fromCase"};

std::string outputOf(const std::string& command)
{
    std::string all;
    auto* pipe = ::popen(command.c_str(), "r");
    std::array<char, 256> part;
    while (pipe && std::fgets(part.data(), part.size(), pipe)) all += part.data();
    if (pipe) ::pclose(pipe);
    return all;
}

/// Without blanks, and numbers in one notation: foamDictionary writes "( 0 -9.81 0 )" and "1e-06".
std::string normal(const std::string& text)
{
    std::string result, word;
    const auto finish = [&]
    {
        char* end = nullptr;
        const double number = std::strtod(word.c_str(), &end);
        char digits[32];
        std::snprintf(digits, sizeof digits, "%.9g", number);
        result += (result.empty() ? "" : " ") + (!word.empty() && *end == '\0' ? std::string(digits) : word);
        word.clear();
    };
    for (const char c : text + " ")
    {
        const bool bracket = std::string("(){}[];").find(c) != std::string::npos;
        if ((std::isspace(static_cast<unsigned char>(c)) || bracket) && !word.empty()) finish();
        if (bracket)
        {
            word = c;
            finish();
        }
        else if (!std::isspace(static_cast<unsigned char>(c))) word += c;
    }
    return result;
}

}

// Each entry of a dictionary with every supported construct has the value that OpenFOAM's own foamDictionary gives it, to 9
// digits (foamDictionary prints 10). And a file that was edited in place is still a dictionary for OpenFOAM.
TEST(FoamDictionary, readsTheSameValues)
{
    if (std::system("command -v foamDictionary >/dev/null 2>&1") != 0)
        GTEST_SKIP() << "left out: OpenFOAM's foamDictionary, which gives the values to compare with, is not installed";
    ::setenv("WM_PROJECT_DIR", "/usr/share/openfoam", 0); // where Debian has OpenFOAM's etc files

    const auto folder = std::filesystem::temp_directory_path() / ("sphFoamDictionary." + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "sample") << sample;
    std::ofstream(folder / "included") << "fromInclude $L;\n";
    std::filesystem::create_directory(folder / "parts");
    std::ofstream(folder / "parts" / "environment") << "FoamFile { version 2.0; format ascii; class dictionary; object other; }\ndeep 6;\n";
    std::ofstream(folder / "parts" / "ofCase") << "fromCase 7;\n";

    const auto theirs = [&](const std::string& entry)
    { return outputOf("cd " + folder.string() + " && foamDictionary -precision 10 -entry '" + entry + "' -value sample 2>&1"); };
    const auto diagnostics = std::make_shared<Diagnostics>();
    const auto dictionary = Dictionary::read(folder, "sample", diagnostics);
    EXPECT_NO_THROW(diagnostics->throwIfAny());
    for (const auto& entry : entries) EXPECT_EQ(normal(valueText(dictionary, entry)), normal(theirs(entry))) << entry;

    setEntry(folder, "sample", "sub.a", "(7 8)");
    setEntry(folder, "sample", "sub.added", "$L");
    EXPECT_EQ(normal(theirs("sub.b")), "( 7 8 )");
    EXPECT_EQ(normal(theirs("sub.added")), "0.002");
    std::filesystem::remove_all(folder);
}
