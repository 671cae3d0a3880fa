#include "Parsed.hpp"

using namespace sph;

using Words = std::vector<std::string>;
using Numbers = std::vector<double>;

// A missing ';' is reported in its own line, and the entry that follows is read: one line or several, numbers, words, lists,
// blocks.
TEST(DictionaryMistakes, missingSemicolon)
{
    const Parsed p("deltaT 0.1\nwriteControl timeStep\nwriteInterval 5;\ng (0 0 -9.81)\nname \"x\"\nsub\n{\n    a 1\n    b 2\n}\n"
                   "list\n(\n    1\n    2\n)\nlast 3\n",
                   "system/controlDict");
    EXPECT_EQ(p.dict.get<double>("deltaT"), 0.1);
    EXPECT_EQ(p.dict.get<std::string>("writeControl"), "timeStep");
    EXPECT_EQ(p.dict.get<int>("writeInterval"), 5);
    EXPECT_EQ(p.dict.get<Vector<3>>("g"), (Vector<3>{0, 0, -9.81}));
    EXPECT_EQ(p.dict.get<std::string>("name"), "x");
    EXPECT_EQ(p.dict.subDict("sub").get<int>("a"), 1);
    EXPECT_EQ(p.dict.subDict("sub").get<int>("b"), 2);
    EXPECT_EQ(p.dict.get<Numbers>("list"), (Numbers{1, 2}));
    EXPECT_EQ(p.dict.get<int>("last"), 3);
    const auto unclosed = [](const char* line, const char* key)
    { return std::string("system/controlDict:") + line + ": entry \"" + key + "\" is not closed by ';'\n"; };
    EXPECT_EQ(p.errors(), unclosed("1", "deltaT") + unclosed("2", "writeControl") + unclosed("4", "g") + unclosed("5", "name") +
                              unclosed("8", "a") + unclosed("9", "b") + unclosed("15", "list") + unclosed("16", "last") + "8 errors");
}

// The same where the next line is indented further, a directive, or a macro; and where the value is missing altogether.
TEST(DictionaryMistakes, missingSemicolonBeforeOtherThings)
{
    EXPECT_EQ(Parsed("a 1\n    b 2;\n").errors(), "constant/d:1: entry \"a\" is not closed by ';'");
    EXPECT_EQ(Parsed("a b\n#remove c\n").errors(), "constant/d:1: entry \"a\" is not closed by ';'");
    EXPECT_EQ(Parsed("s { k 1; }\na b\n$s;\n").errors(), "constant/d:2: entry \"a\" is not closed by ';'");
    EXPECT_EQ(Parsed("a\nb 2;\n").errors(), "constant/d:1: entry \"a\" is not closed by ';'");
    EXPECT_EQ(Parsed("a 1 // comment\n\n\nb 2;\n").errors(), "constant/d:1: entry \"a\" is not closed by ';'");
    const Parsed sameLine("a 1 b 2;\n");
    sameLine.dict.get<double>("a");
    EXPECT_EQ(sameLine.errors(), "constant/d:1: \"a\" has more than one value: \"b 2\" is left over; is a ';' missing?");
}

// What is never closed is reported where it was opened; what follows is read as far as possible.
TEST(DictionaryMistakes, neverClosed)
{
    EXPECT_EQ(Parsed("a 1;\nsub\n{\n    b 2;\n").errors(), "constant/d:3: the '{' of \"sub\" is never closed");
    EXPECT_EQ(Parsed("a\n{\n    b\n    {\n        x 1;\n}\nc 2;\n").errors(),
              "constant/d:4: the '{' of \"b\" is never closed, to judge by the indentation of the '}' in line 6");
    const Parsed list("a (1 2 3;\nb 2;\nc\n(\n    (1 2)\n    (3 4\n)\n;\nd 4;\n");
    EXPECT_EQ(list.dict.get<int>("b"), 2);
    EXPECT_EQ(list.dict.get<int>("d"), 4);
    EXPECT_EQ(list.errors(), "constant/d:1: the '(' of \"a\" is never closed\nconstant/d:4: the '(' of \"c\" is never closed\n2 errors");
    const Parsed list2("a (1 2 3\nb 2;\nc 3;\n");
    EXPECT_EQ(list2.dict.get<int>("b"), 2);
    EXPECT_EQ(list2.errors(), "constant/d:1: the '(' of \"a\" is never closed");
    const Parsed list3("s\n{\n    a (1 2 3\n}\nc 3;\n");
    EXPECT_EQ(list3.dict.get<int>("c"), 3);
    EXPECT_EQ(list3.errors(), "constant/d:3: the '(' of \"a\" is never closed");
    const Parsed text("a \"abc;\nb 2;\n");
    EXPECT_EQ(text.dict.get<std::string>("a"), "abc");
    EXPECT_EQ(text.dict.get<int>("b"), 2);
    EXPECT_EQ(text.errors(), "constant/d:1: this string is not closed by '\"' on its line");
    EXPECT_EQ(Parsed("a 1;\n/* b 2;\nc 3;\n").errors(), "constant/d:2: this comment is never closed by */");
    EXPECT_EQ(Parsed("a 1;\nb #{ x\ny;\n").errors(),
              "constant/d:2: \"#{\" is never closed by \"#}\"\nconstant/d:4: entry \"b\" is not closed by ';'\n2 errors");
    EXPECT_EQ(Parsed("nu [0 2 -1 1e-6;\nb 2;\n").errors(), "constant/d:1: '[' is not closed by ']' on its line");
    EXPECT_EQ(Parsed("u 5{0.5;\nb 2;\n").errors(), "constant/d:1: the '{' of \"u\" is never closed");
}

// Superfluous brackets and stray tokens are reported at their own place.
TEST(DictionaryMistakes, superfluous)
{
    const Parsed p("a 1;\n}\nb 2);\n3 4;\nc = 5;\nd (1 } 2);\nname with blank\n{\n    x 1;\n}\ne 6;\n");
    EXPECT_EQ(p.dict.get<int>("b"), 2);
    EXPECT_EQ(p.dict.get<int>("c"), 5);
    EXPECT_EQ(p.dict.get<Numbers>("d"), (Numbers{1, 2}));
    EXPECT_EQ(p.dict.get<int>("e"), 6);
    EXPECT_EQ(p.errors(), "constant/d:2: '}' closes nothing: there is no open '{'\n"
                          "constant/d:3: ')' closes nothing: there is no open '(' in the value of \"b\"\n"
                          "constant/d:4: expected a keyword, found \"3\"\n"
                          "constant/d:5: \"c\": an entry is written without '='\n"
                          "constant/d:6: '}' closes nothing: there is no open '{' in the value of \"d\"\n"
                          "constant/d:8: '{' is not expected in the value of \"name\": a ';' is missing before it, or the name of a "
                          "dictionary has a blank\n6 errors");
}

// Macros that are not defined, or used as they cannot be.
TEST(DictionaryMistakes, macros)
{
    const Parsed p("length 1;\nb $lenght;\nc $nope;\nk foo;\n$k 3;\n${k}Bar 4;\nx$k 5;\ns { q 1; }\nd $s;\n$length;\ne 5;\n");
    EXPECT_EQ(p.dict.get<int>("e"), 5);
    const std::string undefined = " is neither an entry that is defined above nor an environment variable";
    EXPECT_EQ(p.errors(), "constant/d:2: \"$lenght\"" + undefined + ". Did you mean \"$length\"?\nconstant/d:3: \"$nope\"" + undefined +
                              "\nconstant/d:5: \"$k\": a macro cannot be a keyword\n"
                              "constant/d:6: \"${k}Bar\": a macro must stand alone, it is not replaced inside a word\n"
                              "constant/d:6: \"$k\": a macro cannot be a keyword\n"
                              "constant/d:7: \"x$k\": a macro must stand alone, it is not replaced inside a word\n"
                              "constant/d:9: \"$s\" is a dictionary and cannot be a value; its entries are taken over by { $s; }\n"
                              "constant/d:10: \"$length\" stands among entries, but \"length\" is not a dictionary\n8 errors");
}

// Values of the wrong kind say what is expected and what was found; each look-up gives a harmless value.
TEST(DictionaryMistakes, wrongValues)
{
    const Parsed p("a abc;\nb 1 2;\nc nan;\nd 1e999;\ne -inf;\nf 2.5;\ng maybe;\nh (1 2);\ni;\nj (1 x);\nk 3(1 2);\nl { x 1; }\nm 5;\n"
                   "n [0 1 0 0 0 0 0] 1;\no 3000000000;\np 1;\nq -1;\nr 0;\n");
    p.dict.get<double>("a");
    p.dict.get<double>("b");
    p.dict.get<double>("c");
    p.dict.get<double>("d");
    p.dict.get<double>("e", 7.0);
    p.dict.get<int>("f");
    p.dict.get<bool>("g");
    p.dict.get<Vector<3>>("h");
    p.dict.get<double>("i");
    p.dict.get<Numbers>("j");
    p.dict.get<Numbers>("k");
    p.dict.get<double>("l");
    p.dict.subDict("m").get<double>("silent");
    p.dict.get<double>("n");
    p.dict.get<int>("o");
    p.dict.get<Numbers>("p");
    EXPECT_EQ(p.dict.getNonNegative("q", units::m, 4), 4);
    EXPECT_EQ(p.dict.getPositive("r", units::m), 1);
    EXPECT_EQ(p.errors(), "constant/d:1: \"a\" must be a number, found \"abc\"\n"
                          "constant/d:2: \"b\" has more than one value: \"2\" is left over; is a ';' missing?\n"
                          "constant/d:3: \"c\" must be a finite number, found \"nan\"\n"
                          "constant/d:4: \"d\" must be a finite number, \"1e999\" is too large\n"
                          "constant/d:5: \"e\" must be a finite number, found \"-inf\"\n"
                          "constant/d:6: \"f\" must be an integer, found \"2.5\"\n"
                          "constant/d:7: \"g\" must be yes or no (on/off, true/false), found \"maybe\"\n"
                          "constant/d:8: \"h\" must be a vector \"(x y z)\", found 2 components\n"
                          "constant/d:9: \"i\" must be a number, but its value is missing\n"
                          "constant/d:10: \"j\" must be a number, found \"x\"\n"
                          "constant/d:11: \"k\" is a list that announces 3 values and has 2\n"
                          "constant/d:12: \"l\" must be a value, found a dictionary\n"
                          "constant/d:13: \"m\" must be a dictionary \"{ ... }\", found a value\n"
                          "constant/d:14: \"n\" has dimensions, but a plain number is expected\n"
                          "constant/d:15: \"o\" must be an integer of at most 2147483647, found \"3000000000\"\n"
                          "constant/d:16: \"p\" must be a list \"( ... )\", found \"1\"\n"
                          "constant/d:17: \"q\" must not be negative, found -1\n"
                          "constant/d:18: \"r\" must be positive, found 0\n18 errors");
}

// Dimensions that do not fit are shown beside those expected; unknown units list the known ones.
TEST(DictionaryMistakes, wrongDimensions)
{
    const Parsed p("mu [0 2 -1 0 0 0 0] 1e-3;\nrho [g/m^3] 1;\nnu [0 2 -1] 1;\nx [m^] 1;\n", "constant/phaseProperties");
    EXPECT_EQ(p.dict.getPositive("mu", units::viscosity), 1);
    p.dict.get("rho", units::density);
    p.dict.get("nu", units::kinematicViscosity);
    p.dict.get("x", units::m);
    EXPECT_EQ(p.errors(),
              "constant/phaseProperties:1: \"mu\" has dimensions [0 2 -1 0 0 0 0], expected [1 -1 -1 0 0 0 0]\n"
              "constant/phaseProperties:2: \"rho\" has wrong dimensions: unit \"g\" is unknown. Known units: A, J, K, N, Pa, W, cd, "
              "kg, m, "
              "mol, s.\n"
              "constant/phaseProperties:3: \"nu\" has wrong dimensions: [0 2 -1] has 3 exponents, expected 7: [kg m s K mol A cd]\n"
              "constant/phaseProperties:4: \"x\" has wrong dimensions: '^' is not followed by a number in the units [m^]\n4 errors");
}

// A word that is not among the possible ones is answered with the one meant and all of them.
TEST(DictionaryMistakes, unknownChoice)
{
    const Parsed p("viscosity harmonc;\nkernel cubic;\n", "system/sphSchemes");
    const Words models{"harmonic", "morris", "none"}, kernels{"cubicSpline", "wendlandC2"};
    EXPECT_EQ(p.dict.choose("viscosity", models), "harmonic");
    p.dict.choose("kernel", kernels, "wendlandC2");
    EXPECT_EQ(p.dict.choose("state", kernels, "wendlandC2"), "wendlandC2");
    EXPECT_EQ(p.errors(), "system/sphSchemes:1: viscosity \"harmonc\" is unknown. Did you mean \"harmonic\"? "
                          "Known viscosity: harmonic, morris, none.\n"
                          "system/sphSchemes:2: kernel \"cubic\" is unknown. Did you mean \"cubicSpline\"? "
                          "Known kernel: cubicSpline, wendlandC2.\n2 errors");
}

// A missing entry names the dictionary, and the unread entry that was probably meant.
TEST(DictionaryMistakes, missingEntries)
{
    const Parsed p("deltatT 1;\nfunctions\n{\n    probes { }\n}\n", "system/controlDict");
    p.dict.get<double>("deltaT");
    p.dict.subDict("functions").subDict("probes").get<double>("interval");
    p.dict.subDict("solver").get<double>("silent");
    EXPECT_EQ(p.errors(), "system/controlDict: entry \"deltaT\" is missing. Is \"deltatT\" in line 1 meant?\n"
                          "system/controlDict: dictionary \"solver\" is missing\n"
                          "system/controlDict:4: entry \"interval\" is missing in \"probes\"\n3 errors");
}

// Entries that nothing reads are errors, down into what was read; known keywords and the one meant are named.
TEST(DictionaryMistakes, unusedEntries)
{
    const Parsed p("FoamFile { version 2.0; }\ndeltaT 1;\nwriteIntervall 5;\nsub { a 1; bb 2; }\nother { c 3; }\nwalls ( { x 1; y 2; } );\n"
                   "legacy { d 4; }\n",
                   "system/controlDict");
    p.dict.get<double>("deltaT");
    p.dict.get<double>("writeInterval", 1.0);
    p.dict.subDict("sub").get<int>("a");
    p.dict.dictionaries("walls")[0].get<int>("x");
    p.dict.ignore("legacy");
    p.dict.reportUnused();
    const std::string known = "Known entries: deltaT, writeInterval, sub, walls.\n";
    EXPECT_EQ(p.errors(), "system/controlDict:3: entry \"writeIntervall\" is not used here. Did you mean \"writeInterval\"? " + known +
                              "system/controlDict:4: entry \"bb\" is not used here. Known entries: a.\n"
                              "system/controlDict:5: dictionary \"other\" is not used here. " +
                              known + "system/controlDict:6: entry \"y\" is not used here. Known entries: x.\n4 errors");
}

// An empty dictionary stands for one that is optional: fallbacks hold, and nothing is unused.
TEST(DictionaryMistakes, emptyDictionaries)
{
    const auto diagnostics = std::make_shared<Diagnostics>();
    const auto d = Dictionary::empty("system/sphControl", diagnostics);
    EXPECT_EQ(d.get("x", units::m, 2), 2);
    EXPECT_EQ(d.subDictOrEmpty("sub").get<std::string>("word", "default"), "default");
    d.reportUnused();
    EXPECT_TRUE(diagnostics->ok());
}
