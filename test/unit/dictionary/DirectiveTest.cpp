#include "Parsed.hpp"
#include "dictionary/Parameter.hpp"
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <unistd.h>

using namespace sph;

namespace
{

/// A case folder of its own for each test.
struct CaseFolder
{
    std::filesystem::path path = std::filesystem::temp_directory_path() / ("sphDictionaryTest." + std::to_string(::getpid()));
    CaseFolder() { std::filesystem::create_directories(path / "constant"); }
    ~CaseFolder() { std::filesystem::remove_all(path); }
    void write(const std::string& file, const std::string& text) const
    {
        std::filesystem::create_directories((path / file).parent_path());
        std::ofstream(path / file) << text;
    }
};

std::string errorsOf(const std::shared_ptr<Diagnostics>& diagnostics)
{
    try
    {
        diagnostics->throwIfAny();
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
    return "";
}

}

// Included entries keep the file and line in which they stand, as named from the case folder; nesting and optional files work.
TEST(DictionaryDirectives, includeKeepsFileAndLine)
{
    const CaseFolder folder;
    folder.write("constant/d", "#include \"parts/common\"\n#includeIfPresent \"nope\"\n#sinclude \"nope2\"\nx $rhoCommon;\nown 1;\n");
    folder.write("constant/parts/common", "\nrhoCommon 1234;\n#include \"../deeper\"\n");
    folder.write("constant/deeper", "sub { bad abc; }\n#include \"<system>/last\"\n");
    folder.write("system/last", "z 26;\n");
    const auto diagnostics = std::make_shared<Diagnostics>();
    const auto d = Dictionary::read(folder.path, "constant/d", diagnostics);
    EXPECT_EQ(d.get<double>("x"), 1234);
    EXPECT_EQ(d.get<double>("own"), 1);
    EXPECT_EQ(d.get<double>("z"), 26);
    EXPECT_EQ(toString(d.where("rhoCommon")), "constant/parts/common:2");
    d.subDict("sub").get<double>("bad");
    EXPECT_EQ(errorsOf(diagnostics), "constant/deeper:1: \"bad\" must be a number, found \"abc\"");
}

// A missing include, one that includes itself, and mistakes inside an included file are reported at their own place.
TEST(DictionaryDirectives, includeMistakes)
{
    const CaseFolder folder;
    folder.write("constant/d", "a 1;\n#include \"nofile\"\n#include \"d\"\n#include \"bad\"\nb 2;\n");
    folder.write("constant/bad", "\nc 3\n");
    const auto diagnostics = std::make_shared<Diagnostics>();
    const auto d = Dictionary::read(folder.path, "constant/d", diagnostics);
    EXPECT_EQ(d.get<int>("b"), 2);
    EXPECT_EQ(errorsOf(diagnostics), "constant/bad:2: entry \"c\" is not closed by ';'\n"
                                     "constant/d:2: there is no file \"constant/nofile\" to include\n"
                                     "constant/d:3: \"d\" includes itself\n3 errors");
}

/// A variable of the environment, and no more once the test is over.
struct Environment
{
    std::string name;
    Environment(const std::string& variable, const std::string& value) : name(variable) { setenv(name.c_str(), value.c_str(), 1); }
    ~Environment() { unsetenv(name.c_str()); }
};

// Variables and names of folders in an included path are expanded as foamDictionary 1912 and OpenFOAM 11 expand them: entries of the
// dictionary in braces, then the environment's, FOAM_CASE whatever the shell says; `./` is the case and not the folder of the including
// file.
TEST(DictionaryDirectives, pathsOfIncludes)
{
    const CaseFolder folder;
    auto number = [&, n = 0](const std::string& path) mutable
    {
        const auto value = std::to_string(++n);
        folder.write(path, "found " + value + ";\n");
        return n;
    };
    const int ofCase = number("part"), ofConstant = number("constant/part"), ofSystem = number("system/deep/part"),
              ofEtc = number("project/etc/caseDicts/part"), outside = number("meshes/part");
    const Environment shell("FOAM_CASE", "/nowhere"), meshes("SPH_TEST_MESHES", (folder.path / "meshes").string()),
        project("WM_PROJECT_DIR", (folder.path / "project").string());
    const auto found = [&](const std::string& include)
    {
        folder.write("system/d", "where constant; sub { name part; }\n" + include + "\n");
        const auto diagnostics = std::make_shared<Diagnostics>();
        const int value = Dictionary::read(folder.path, "system/d", diagnostics).get<int>("found", 0);
        EXPECT_EQ(errorsOf(diagnostics), "") << include;
        return value;
    };
    EXPECT_EQ(found("#include \"$FOAM_CASE/part\""), ofCase);
    EXPECT_EQ(found("#include \"${FOAM_CASE}/constant/part\""), ofConstant);
    EXPECT_EQ(found("#include \"<case>/part\""), ofCase);
    EXPECT_EQ(found("#include \"./part\""), ofCase);
    EXPECT_EQ(found("#include \"../part\""), ofCase);
    EXPECT_EQ(found("#include \"<constant>/part\""), ofConstant);
    EXPECT_EQ(found("#include \"<system>/deep/part\""), ofSystem);
    EXPECT_EQ(found("#include \"deep/part\""), ofSystem);
    EXPECT_EQ(found("#include \"$FOAM_CASE/${where}/${sub.name}\""), ofConstant);
    EXPECT_EQ(found("#include \"$FOAM_CASE/$where/part\""), ofConstant);
    EXPECT_EQ(found("a where;\n#include \"<case>/${${a}}/part\""), ofConstant);
    EXPECT_EQ(found("#include \"$SPH_TEST_MESHES/part\""), outside);
    EXPECT_EQ(found("#include \"${SPH_TEST_NONE:-$FOAM_CASE/meshes}/part\""), outside);
    EXPECT_EQ(found("#include \"<etc>/caseDicts/part\""), ofEtc);
    EXPECT_EQ(found("#include \"~OpenFOAM/caseDicts/part\""), ofEtc);
    EXPECT_EQ(found("#include \"$WM_PROJECT_DIR/etc/caseDicts/part\""), ofEtc);
    EXPECT_EQ(found("#includeEtc \"caseDicts/part\""), ofEtc);
    EXPECT_EQ(found("kind caseDicts;\n#includeEtc \"${kind}/part\""), ofEtc);
    EXPECT_EQ(found("#includeIfPresent \"<constant>/part\""), ofConstant);
    EXPECT_EQ(found("#sinclude \"<constant>/none\""), 0);
    EXPECT_EQ(found("#includeIfPresent \"$SPH_TEST_NONE/part\""), 0);
}

// A path that cannot be expanded is refused where it stands, with what it lacks.
TEST(DictionaryDirectives, pathsThatCannotBeExpanded)
{
    const CaseFolder folder;
    const auto mistake = [&](const std::string& text)
    {
        folder.write("system/d", text);
        const auto diagnostics = std::make_shared<Diagnostics>();
        Dictionary::read(folder.path, "system/d", diagnostics);
        return errorsOf(diagnostics);
    };
    EXPECT_EQ(mistake("\n#include \"$SPH_TEST_NONE/part\"\n"),
              "system/d:2: #include \"$SPH_TEST_NONE/part\" names $SPH_TEST_NONE, which is neither an entry that is defined above nor an "
              "environment variable");
    EXPECT_EQ(mistake("#include \"<cse>/part\"\n"),
              "system/d:1: #include \"<cse>/part\" begins with <cse>; known are <case>, <constant>, <system> and <etc>");
    EXPECT_EQ(mistake("#include \"${FOAM_CASE/part\"\n"),
              "system/d:1: #include \"${FOAM_CASE/part\" has \"${FOAM_CASE/part\", which is not closed by '}'");
    EXPECT_EQ(mistake("list (a b);\n#include \"${list}/part\"\n"),
              "system/d:2: #include \"${list}/part\" names $list, which is not one word");
    EXPECT_EQ(mistake("#include \"$FOAM_CASE/constant/none\"\n"), "system/d:1: there is no file \"constant/none\" to include");
    EXPECT_EQ(mistake("#includeEtc \"caseDicts/part\"\n"),
              "system/d:1: #includeEtc \"caseDicts/part\" is sought in etc folders, and neither of the environment variables "
              "SPH_PROJECT_DIR and WM_PROJECT_DIR, below which they are, is set");
}

// The header of an included file is not the including one's, in a dictionary within it neither: of the tutorials of OpenFOAM 11 and 1912 43
// files differed from foamDictionary in this.
TEST(DictionaryDirectives, headersOfIncludedFiles)
{
    const CaseFolder folder;
    folder.write("constant/d", "FoamFile { object d; }\n#include \"part\"\nsub { #include \"part\"\n }\n");
    folder.write("constant/part", "FoamFile { object part; }\nx { FoamFile { y 1; } }\n");
    const auto diagnostics = std::make_shared<Diagnostics>();
    const auto d = Dictionary::read(folder.path, "constant/d", diagnostics);
    EXPECT_EQ(d.subDict("FoamFile").get<std::string>("object"), "d");
    EXPECT_FALSE(d.subDict("sub").found("FoamFile"));
    EXPECT_EQ(d.subDict("sub").subDict("x").subDict("FoamFile").get<int>("y"), 1);
    EXPECT_EQ(errorsOf(diagnostics), "");
}

// The suite's etc folder comes before OpenFOAM's.
TEST(DictionaryDirectives, etcFolders)
{
    const CaseFolder folder;
    folder.write("suite/etc/both", "found 1;\n");
    folder.write("foam/etc/both", "found 2;\n");
    folder.write("foam/etc/one", "other 3;\n");
    folder.write("constant/d", "#includeEtc \"both\"\n#include \"<etc>/one\"\n#sincludeEtc \"none\"\n#includeEtc \"none\"\n");
    const Environment suite("SPH_PROJECT_DIR", (folder.path / "suite").string()), foam("WM_PROJECT_DIR", (folder.path / "foam").string());
    const auto diagnostics = std::make_shared<Diagnostics>();
    const auto d = Dictionary::read(folder.path, "constant/d", diagnostics);
    EXPECT_EQ(d.get<int>("found"), 1);
    EXPECT_EQ(d.get<int>("other"), 3);
    EXPECT_EQ(errorsOf(diagnostics), "constant/d:4: there is no file \"foam/etc/none\" to include");
}

// A file that an entry names is found by the same rules, relative to the folder that the entry is about, and through a link to the case.
TEST(DictionaryDirectives, pathsInEntries)
{
    const CaseFolder folder;
    const FileName file("file", "constant/triSurface", required, "");
    const auto link = folder.path.string() + ".link";
    std::filesystem::create_directory_symlink(folder.path, link);
    const Environment meshes("SPH_TEST_MESHES", (folder.path / "meshes").string());
    const auto read = [&](const std::string& text, const std::filesystem::path& caseFolder)
    {
        folder.write("constant/d", "\nfile \"" + text + "\";\n");
        const auto diagnostics = std::make_shared<Diagnostics>();
        const auto path = file(Dictionary::read(caseFolder, "constant/d", diagnostics));
        const auto mistakes = errorsOf(diagnostics);
        return mistakes.empty() ? path : mistakes;
    };
    for (const auto& caseFolder : {folder.path, std::filesystem::path(link)})
    {
        EXPECT_EQ(read("rock.stl", caseFolder), "rock.stl");
        EXPECT_EQ(read("<constant>/triSurface/rock.stl", caseFolder), "rock.stl");
        EXPECT_EQ(read("$FOAM_CASE/rock.stl", caseFolder), "../../rock.stl");
        EXPECT_EQ(read("${SPH_TEST_MESHES}/rock.stl", caseFolder), "../../meshes/rock.stl");
        EXPECT_EQ(
            read("$SPH_TEST_NONE/rock.stl", caseFolder),
            "constant/d:2: \"file\": \"$SPH_TEST_NONE/rock.stl\" names $SPH_TEST_NONE, which is neither an entry that is defined above "
            "nor an environment variable");
    }
    std::filesystem::remove(link);
}

// A missing dictionary names the file that was probably meant, and is not followed by an error for each of its entries.
TEST(DictionaryDirectives, missingFile)
{
    const CaseFolder folder;
    folder.write("system/controlDct", "");
    const auto diagnostics = std::make_shared<Diagnostics>();
    const auto d = Dictionary::read(folder.path, "system/controlDict", diagnostics);
    d.get<double>("deltaT");
    d.subDict("functions").get<double>("x");
    EXPECT_EQ(errorsOf(diagnostics), "system/controlDict: there is no such file. Is \"controlDct\" meant?");
}

// The input modes do what foamDictionary 1912 did for the same text.
TEST(DictionaryDirectives, inputModes)
{
    const Parsed p(R"(sub {a 1;}
        #inputMode merge
        sub { added 5; a 2; }
        other { a 1; }
        #inputMode overwrite
        sub { z 1; }
        a1 1; a1 2;
        #inputMode protect
        a1 3; b1 1;
        #inputMode default
        a1 4;
        #default a1 5;
        #default c1 6;
        #inputMode warn
        c1 7;)");
    EXPECT_EQ(p.dict.subDict("sub").keys(), (std::vector<std::string>{"z"}));
    EXPECT_EQ(p.dict.get<int>("a1"), 4);
    EXPECT_EQ(p.dict.get<int>("b1"), 1);
    EXPECT_EQ(p.dict.get<int>("c1"), 6);
    EXPECT_EQ(p.errors(), "");
    EXPECT_EQ(p.diagnostics->warnings().back(), "constant/d:15: \"c1\" is given twice, first in constant/d:13, which is kept");
    EXPECT_EQ(Parsed("a 1;\n#inputMode error\na 2;\n").errors(), "constant/d:3: \"a\" is given twice, first in constant/d:1");
    EXPECT_EQ(Parsed("#inputMode protct\n").errors(), "constant/d:1: input mode \"protct\" is unknown. Did you mean \"protect\"? "
                                                      "Known modes: default, error, merge, overwrite, protect, warn.");
}

// #remove takes a keyword or a list with patterns.
TEST(DictionaryDirectives, remove)
{
    const Parsed p("a 1; b 2; y1 3; y2 4; c 5;\n#remove a\n#remove (b \"y.*\")\n");
    EXPECT_EQ(p.dict.keys(), (std::vector<std::string>{"c"}));
    EXPECT_EQ(p.errors(), "");
}

// Branches are chosen as foamDictionary 1912 chose them; nested ones in a skipped branch do not count.
TEST(DictionaryDirectives, branches)
{
    const Parsed p(R"(L 1e-3; only 3;
        #ifeq $L 1e-3
        a yes;
        #else
        a no;
        #endif
        #ifeq ${L} "1e-3"
        b yes;
        #else
        b no;
        #endif
        #if 0
            #if 1
            c 1;
            #else
            c 5;
            #endif
            c2 $only;
        #elif 1
        c 2;
        #else
        c 3;
        #endif
        #if #eval{ $L < 1 && 2 > 1 }
        d 1;
        #endif
        #if off
        e "never { closed;
        #endif
    )");
    EXPECT_EQ(p.dict.get<std::string>("a"), "yes");
    EXPECT_EQ(p.dict.get<std::string>("b"), "no");
    EXPECT_EQ(p.dict.get<int>("c"), 2);
    EXPECT_EQ(p.dict.get<int>("d"), 1);
    p.dict.reportUnused();
    EXPECT_EQ(p.errors(), "constant/d:28: this string is not closed by '\"' on its line");
    EXPECT_EQ(Parsed("a 1;\n#if yes\nb 2;\n").errors(), "constant/d:2: #if is never ended by #endif");
    EXPECT_EQ(Parsed("#else\n").errors(), "constant/d:1: #else without an #if or #ifeq before it");
    EXPECT_EQ(Parsed("x 1;\n#if $x == 1\nb 2;\n#endif\n").errors(),
              "constant/d:2: #if needs a number or yes/no, found \"1 = = 1\"; comparisons are written #if #eval{ ... }");
}

// Expressions: precedence, functions, macros and vectors against values worked out by hand, to round-off.
TEST(DictionaryDirectives, eval)
{
    const Parsed p(R"(L 1e-3; U (1 2 2); nu [m^2/s] 1e-6; sub { n 3; }
        a #eval "2.0*$L + 1"; b #eval{ sqrt(2) }; c #eval{ -2^2 }; d #eval{ 2^3^2 }; e #eval{ (1 + 2)*3 - 7 % 4 };
        f #eval{ sin(degToRad(30)) }; g #eval{ mag($U) }; h #eval{ mag(vector(1,2,2)) + $sub.n }; i (#eval{1+1} 2 #eval{3});
        j #eval{ atan2(1, 1)/pi()*4 }; k #eval{ max(1, 2) == 2 ? 10 : 20 }; l #eval{ 2*$U + vector(0, 0, 1) }; m #eval "1/3";
        n #eval{ $nu/1e-6 }; o #eval{ round(2.5) + log(e()) }; q #eval
        { 1 +
          1 }; r #eval{ sqr(cosh(0.7)) - sqr(sinh(0.7)) + tanh(0.5)*(1 + e())/(e() - 1) };)");
    EXPECT_DOUBLE_EQ(p.dict.get<double>("r"), 2);
    EXPECT_DOUBLE_EQ(p.dict.get<double>("a"), 1.002);
    EXPECT_DOUBLE_EQ(p.dict.get<double>("b"), std::numbers::sqrt2);
    EXPECT_EQ(p.dict.get<double>("c"), -4);
    EXPECT_EQ(p.dict.get<double>("d"), 512);
    EXPECT_EQ(p.dict.get<double>("e"), 6);
    EXPECT_DOUBLE_EQ(p.dict.get<double>("f"), 0.5);
    EXPECT_EQ(p.dict.get<double>("g"), 3);
    EXPECT_EQ(p.dict.get<double>("h"), 6);
    EXPECT_EQ(p.dict.get<Vector<3>>("i"), (Vector<3>{2, 2, 3}));
    EXPECT_DOUBLE_EQ(p.dict.get<double>("j"), 1);
    EXPECT_EQ(p.dict.get<int>("k"), 10);
    EXPECT_EQ(p.dict.get<Vector<3>>("l"), (Vector<3>{2, 4, 5}));
    EXPECT_EQ(p.dict.get<double>("m"), 1.0 / 3.0) << "no digit may be lost between an expression and its value";
    EXPECT_EQ(p.dict.get<double>("n"), 1);
    EXPECT_EQ(p.dict.get<double>("o"), 4);
    EXPECT_EQ(p.dict.get<double>("q"), 2);
    EXPECT_EQ(p.errors(), "");
}

// Mistakes in expressions name their line, the mistake and the expression.
TEST(DictionaryDirectives, evalMistakes)
{
    const Parsed p("length 2;\na #eval{ 1 + };\nb #eval{ 1 + $lenght };\nc #eval \"sqr(2\";\nd #eval{ 1/0 };\ne #eval{ sqrt(-1) };\n"
                   "f #eval{ sqt(2) };\ng #eval{ pow(2) };\nh #eval{ 1 2 };\n");
    EXPECT_EQ(
        p.errors(),
        "constant/d:2: #eval \"1 +\": a value is missing at the end\n"
        "constant/d:3: #eval \"1 + $lenght\": \"$lenght\" is not defined above. Did you mean \"$length\"?\n"
        "constant/d:4: #eval \"sqr(2\": expected \")\" at the end\n"
        "constant/d:5: #eval \"1/0\": division by zero\n"
        "constant/d:6: #eval \"sqrt(-1)\": the result is not a number\n"
        "constant/d:7: #eval \"sqt(2)\": \"sqt\" is unknown (a macro is written $sqt). Did you mean \"sqr\"? Known functions: "
        "dot, mag, vector, grad, smooth, "
        "abs, acos, asin, atan, atan2, cbrt, ceil, cos, cosh, degToRad, e, erf, erfc, exp, floor, log, log10, max, min, pi, pow, radToDeg, round, "
        "sin, sinh, sqr, sqrt, tan, tanh.\n"
        "constant/d:8: #eval \"pow(2)\": pow() takes 2 arguments, found 1\n"
        "constant/d:9: #eval \"1 2\": unexpected \"2 \"\n8 errors");
}

// What is not supported says why; what is unknown, what is possible. Reading goes on behind either.
TEST(DictionaryDirectives, unsupportedAndUnknown)
{
    const Parsed p("a #calc \"1 + 2\";\nb #codeStream { code #{ x; #}; };\n#nosuch \"x\"\n#inclde \"y\"\nc 3;\n");
    EXPECT_EQ(p.dict.get<int>("c"), 3);
    const std::string known = "Known directives: default, elif, else, endif, error, eval, if, ifeq, include, includeEtc, "
                              "includeIfPresent, inputMode, merge, overwrite, remove, sinclude, sincludeEtc, warn.";
    const std::string why = " is not supported: it compiles C++ code against OpenFOAM's own libraries while the case is read. "
                            "#eval{ ... } calculates values\n";
    EXPECT_EQ(p.errors(), "constant/d:1: #calc" + why + "constant/d:2: #codeStream" + why +
                              "constant/d:3: directive \"#nosuch\" is unknown. " + known +
                              "\nconstant/d:4: directive \"#inclde\" is unknown. Did you mean \"include\"? " + known + "\n4 errors");
}
