#include "Parsed.hpp"
#include "dictionary/DictionaryText.hpp"
#include <cstdlib>

using namespace sph;

using Words = std::vector<std::string>;
using Numbers = std::vector<double>;

// Words, strings, numbers and switches read as OpenFOAM's foamDictionary shows them for the same text.
TEST(DictionarySyntax, scalarValues)
{
    const Parsed p(R"(FoamFile { version 2.0; format ascii; class dictionary; object d; }
        w foo<bar>:baz.q; div(phi,U) Gauss; s "a; $L {x} \"q\""; long "line1\
line2"; verb #{ code here; $x #};
        n -1.5e-3; i 42; j 1e6; d 1.; dd .5; plus +3; // rest
        c /* in; line */ 3; yes on; no off; t t; f false; uml "äöü";)");
    EXPECT_EQ(p.dict.get<std::string>("w"), "foo<bar>:baz.q");
    EXPECT_EQ(p.dict.get<std::string>("div(phi,U)"), "Gauss");
    EXPECT_EQ(p.dict.get<std::string>("s"), "a; $L {x} \"q\"");
    EXPECT_EQ(p.dict.get<std::string>("long"), "line1\nline2");
    EXPECT_EQ(p.dict.get<std::string>("verb"), " code here; $x ");
    EXPECT_EQ(p.dict.get<double>("n"), -1.5e-3);
    EXPECT_EQ(p.dict.get<int>("i"), 42);
    EXPECT_EQ(p.dict.get<int>("j"), 1000000);
    EXPECT_EQ(p.dict.get<double>("d"), 1);
    EXPECT_EQ(p.dict.get<double>("dd"), 0.5);
    EXPECT_EQ(p.dict.get<double>("plus"), 3);
    EXPECT_EQ(p.dict.get<double>("c"), 3);
    EXPECT_TRUE(p.dict.get<bool>("yes"));
    EXPECT_FALSE(p.dict.get<bool>("no"));
    EXPECT_TRUE(p.dict.get<bool>("t"));
    EXPECT_FALSE(p.dict.get<bool>("f"));
    EXPECT_EQ(p.dict.get<std::string>("uml"), "äöü");
    EXPECT_EQ(p.dict.keys().size(), 17u) << "FoamFile is not listed";
    p.dict.reportUnused();
    EXPECT_EQ(p.errors(), "");
}

// Every written form of a list gives the same values; nested lists and vectors too.
TEST(DictionarySyntax, lists)
{
    const Parsed p(R"(l1 (1 2 3); l2 3(1 2 3); l3 List<scalar> 3(1 2 3); l4 nonuniform List<scalar>
3
(
1
2
3
)
;
        u 3{0.5}; uu List<scalar> 3{0.5}; empty (); none 0(); g (0 -9.81 0); gu uniform (0 -9.81 0); x uniform 4;
        nested ((1 2)(3 4)); mixed (2(1 2) 2{7}); words (a b "c.*"); vectors 2((0 0 0) (1 2 3));)");
    for (const auto* key : {"l1", "l2", "l3", "l4"}) EXPECT_EQ(p.dict.get<Numbers>(key), (Numbers{1, 2, 3})) << key;
    EXPECT_EQ(p.dict.get<Numbers>("u"), (Numbers{0.5, 0.5, 0.5}));
    EXPECT_EQ(p.dict.get<Numbers>("uu"), (Numbers{0.5, 0.5, 0.5}));
    EXPECT_TRUE(p.dict.get<Numbers>("empty").empty());
    EXPECT_TRUE(p.dict.get<Numbers>("none").empty());
    EXPECT_EQ(p.dict.get<Vector<3>>("g"), (Vector<3>{0, -9.81, 0}));
    EXPECT_EQ(p.dict.get<Vector<3>>("gu"), (Vector<3>{0, -9.81, 0}));
    EXPECT_EQ(p.dict.get<double>("x"), 4);
    EXPECT_EQ(p.dict.get<std::vector<Numbers>>("nested"), (std::vector<Numbers>{{1, 2}, {3, 4}}));
    EXPECT_EQ(p.dict.get<std::vector<Numbers>>("mixed"), (std::vector<Numbers>{{1, 2}, {7, 7}}));
    EXPECT_EQ(p.dict.get<Words>("words"), (Words{"a", "b", "c.*"}));
    EXPECT_EQ(p.dict.get<std::vector<Vector<3>>>("vectors"), (std::vector<Vector<3>>{{0, 0, 0}, {1, 2, 3}}));
    EXPECT_EQ(p.errors(), "");
}

// Dimensions in each form; the plain value is taken to be in the expected SI units.
TEST(DictionarySyntax, dimensionedValues)
{
    const Parsed p(R"(nu [0 2 -1 0 0 0 0] 1e-6; nu2 nu [0 2 -1 0 0 0 0] 1e-6; nu3 [m^2/s] 1e-6; nu4 [0 2 -1 0 0] 1e-6;
        nu5 1e-6 [m^2/s]; nu6 1e-6; mu [Pa s] 1e-3; sigma [N/m] 0.072; sigma2 [J m^-2] 0.072;
        rho [kg/(m m^2)] 1000; n [] 2; n2 [-] 2;
        g [m s^-2] (0 -9.81 0); f [1/s] 3;)");
    for (const auto* key : {"nu", "nu2", "nu3", "nu4", "nu5", "nu6"}) EXPECT_EQ(p.dict.get(key, units::kinematicViscosity), 1e-6) << key;
    EXPECT_EQ(p.dict.get("mu", units::viscosity), 1e-3);
    EXPECT_EQ(p.dict.get("sigma", units::surfaceTension), 0.072);
    EXPECT_EQ(p.dict.get("sigma2", units::surfaceTension), 0.072);
    EXPECT_EQ(p.dict.get("rho", units::density), 1000);
    EXPECT_EQ(p.dict.get("n", units::none), 2);
    EXPECT_EQ(p.dict.get("n2", units::none), 2);
    EXPECT_EQ(p.dict.getVector("g", units::mPerS2), (Vector<3>{0, -9.81, 0}));
    EXPECT_EQ(p.dict.get("f", units::none / units::s), 3);
    EXPECT_EQ(p.errors(), "");
}

// Dictionaries in lists keep their order; named ones their names.
TEST(DictionarySyntax, listsOfDictionaries)
{
    const Parsed p(R"(base { q 1; }
        walls ( { type a; } { type b; n 2; } );
        regions 2( left { set 1; points ((0 0 0) (1 1 1)); } right { $base; } );)");
    const auto walls = p.dict.dictionaries("walls");
    ASSERT_EQ(walls.size(), 2u);
    EXPECT_EQ(walls[0].get<std::string>("type"), "a");
    EXPECT_EQ(walls[1].get<int>("n"), 2);
    EXPECT_EQ(walls[1].keyword(), "1");
    const auto regions = p.dict.dictionaries("regions");
    ASSERT_EQ(regions.size(), 2u);
    EXPECT_EQ(regions[0].keyword(), "left");
    EXPECT_EQ(regions[0].name(), "constant/d.regions.left");
    EXPECT_EQ(regions[0].get<std::vector<Vector<3>>>("points")[1], (Vector<3>{1, 1, 1}));
    EXPECT_EQ(regions[1].get<int>("q"), 1);
    EXPECT_EQ(p.errors(), "");
}

// The name of a dictionary in a list is written as it was read: without its quotes "(a|b).*" would be read as a list.
TEST(DictionarySyntax, quotedNamesInLists)
{
    const Parsed p("patches ( \"(walls|cyc).*\" { type rebound; } outlet { type escape; } );");
    const auto text = valueText(p.dict, "patches");
    EXPECT_NE(text.find("(\"(walls|cyc).*\" {"), text.npos) << text;
    EXPECT_EQ(valueText(Parsed("patches " + text + ";").dict, "patches"), text);
    EXPECT_EQ(p.dict.dictionaries("patches")[0].keyword(), "(walls|cyc).*");
}

// OpenFOAM's `sigma` list, with and without "and".
TEST(DictionarySyntax, pairsOfWordsWithValues)
{
    const Parsed p("sigma ( (water air) 0.072 (water and oil) 0.03 );");
    const auto pairs = p.dict.pairs("sigma");
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_EQ(pairs[0].second, "air");
    EXPECT_EQ(pairs[1].first, "water");
    EXPECT_EQ(pairs[1].second, "oil");
    EXPECT_EQ(pairs[1].value, 0.03);
    EXPECT_EQ(p.errors(), "");
}

// Macros find what foamDictionary finds for the same text (the values are those that OpenFOAM 1912 printed).
TEST(DictionarySyntax, macrosSearchScopesAsOpenFOAM)
{
    const Parsed p(R"(L 1e-3; sub2 { x 7; }
        sub { a 1; L 2e-3; b $a; c $L; d $..L; dd $:L; e ${a}; f $:sub2.x; nested { z $..a; top $...L; alt ${..L}; up $a; } }
        v ($sub.a $:sub2.x 3); vv ((1 $sub.a)($L ${L})); alpha.water 5; w $alpha.water; root ${/sub/c}; root2 $/sub/c;)");
    const auto sub = p.dict.subDict("sub"), nested = sub.subDict("nested");
    EXPECT_EQ(sub.get<double>("b"), 1);
    EXPECT_EQ(sub.get<double>("c"), 2e-3);
    EXPECT_EQ(sub.get<double>("d"), 1e-3);
    EXPECT_EQ(sub.get<double>("dd"), 1e-3);
    EXPECT_EQ(sub.get<double>("e"), 1);
    EXPECT_EQ(sub.get<double>("f"), 7);
    EXPECT_EQ(nested.get<double>("z"), 1);
    EXPECT_EQ(nested.get<double>("top"), 1e-3);
    EXPECT_EQ(nested.get<double>("alt"), 2e-3);
    EXPECT_EQ(nested.get<double>("up"), 1);
    EXPECT_EQ(p.dict.get<Vector<3>>("v"), (Vector<3>{1, 7, 3}));
    EXPECT_EQ(p.dict.get<std::vector<Numbers>>("vv"), (std::vector<Numbers>{{1, 1}, {1e-3, 1e-3}}));
    EXPECT_EQ(p.dict.get<double>("w"), 5);
    EXPECT_EQ(p.dict.get<double>("root"), 2e-3);
    EXPECT_EQ(p.dict.get<double>("root2"), 2e-3);
    p.dict.reportUnused();
    EXPECT_EQ(p.errors(), "") << "what a macro uses is used";
}

// A dictionary macro takes over entries, in the order of writing; its own text keeps its place.
TEST(DictionarySyntax, dictionaryMacros)
{
    const Parsed p("base { type wall; v 1; in { k 3; } }\np1 { $base; v 2; in { k 4; } }\np2 { v 2; ${base} }\np3 { $:base; }\n");
    EXPECT_EQ(p.dict.subDict("p1").get<int>("v"), 2);
    EXPECT_EQ(p.dict.subDict("p1").subDict("in").get<int>("k"), 4);
    EXPECT_EQ(p.dict.subDict("p2").get<int>("v"), 1);
    EXPECT_EQ(p.dict.subDict("p3").get<std::string>("type"), "wall");
    EXPECT_EQ(p.dict.subDict("p3").subDict("in").get<int>("k"), 3);
    EXPECT_EQ(p.dict.subDict("base").subDict("in").get<int>("k"), 3);
    EXPECT_EQ(p.dict.subDict("p1").where("type").line, 1);
    EXPECT_EQ(p.errors(), "");
}

// An environment variable is found where no entry has its name.
TEST(DictionarySyntax, environment)
{
    setenv("SPH_TEST_NUMBER", "12.5", 1);
    setenv("SPH_TEST_PATH", "/a b/c", 1);
    const Parsed p("n $SPH_TEST_NUMBER; s $SPH_TEST_PATH;");
    EXPECT_EQ(p.dict.get<double>("n"), 12.5);
    EXPECT_EQ(p.dict.get<std::string>("s"), "/a b/c");
    EXPECT_EQ(p.errors(), "");
}

// An exact keyword beats a pattern; among patterns the last one wins (as OpenFOAM 1912).
TEST(DictionarySyntax, patterns)
{
    const Parsed p(R"("p.*" { type wall; } ".*" { type other; } "(inlet|outlet).*" { type patch; } inletA { type exact; })");
    EXPECT_EQ(p.dict.subDict("inletA").get<std::string>("type"), "exact");
    EXPECT_EQ(p.dict.subDict("inletB").get<std::string>("type"), "patch");
    EXPECT_EQ(p.dict.subDict("pX").get<std::string>("type"), "other");
    EXPECT_TRUE(p.dict.found("zzz"));
    const Parsed macro("\"p.*\" { k 5; } b $pX.k;");
    EXPECT_EQ(macro.dict.get<int>("b"), 5) << "a pattern must not take the path for a keyword";
}

// A pattern that is given again counts as the last one, and stands where it stood (as OpenFOAM 1912).
TEST(DictionarySyntax, repeatedPatterns)
{
    const Parsed p("\"a.*\" 1;\n\"ab.*\" 2;\n\"a.*\" 3;\n");
    EXPECT_EQ(p.dict.get<int>("abc"), 3);
    EXPECT_EQ(keywords(p.dict, ""), (Words{"\"a.*\"", "\"ab.*\""}));
}

// The last of two equal keywords counts, with a warning; dictionaries merge.
TEST(DictionarySyntax, duplicates)
{
    const Parsed p("a 1;\na 2;\nsub { x 1; }\nsub { y 2; }\n");
    EXPECT_EQ(p.dict.get<int>("a"), 2);
    EXPECT_EQ(p.dict.where("a").line, 2);
    EXPECT_EQ(p.dict.subDict("sub").keys(), (Words{"x", "y"}));
    EXPECT_EQ(p.errors(), "");
    EXPECT_EQ(p.diagnostics->warnings(), (Words{"constant/d:2: \"a\" is given twice, first in constant/d:1; the last one counts"}));
}

// A macro's value is fixed where the macro stands, as in OpenFOAM: what is given anew behind it comes too late for it, and the warning says so,
// also where the value stands in an included file or in a copy and giving it anew is the usual way to vary it.
TEST(DictionarySyntax, duplicatesBehindMacros)
{
    const Parsed p("unit 1;\na $unit;\nb #eval{ 2*$unit };\nunit 3;\nc $unit;\nunit 3;\n");
    EXPECT_EQ(p.dict.get<int>("a"), 1);
    EXPECT_EQ(p.dict.get<int>("b"), 2);
    EXPECT_EQ(p.dict.get<int>("c"), 3);
    const std::string twice = "\"unit\" is given twice, first in constant/d:";
    EXPECT_EQ(p.diagnostics->warnings(),
              (Words{"constant/d:4: " + twice + "1; the last one counts, but comes too late for the macros in constant/d:2, constant/d:3",
                     "constant/d:6: " + twice + "4; the last one counts"}));

    const Parsed copy("base { unit 1; }\nrun { $base; a $unit; unit 2; }\n");
    EXPECT_EQ(copy.dict.subDict("run").get<int>("a"), 1);
    EXPECT_EQ(copy.diagnostics->warnings(),
              (Words{"constant/d:2: " + twice + "1; the last one counts, but comes too late for the macro in constant/d:2"}));

    const Parsed block("base { unit 1; }\nrun { $base; }\nbase { unit 2; }\n");
    EXPECT_EQ(block.dict.subDict("run").get<int>("unit"), 1);
    EXPECT_EQ(
        block.diagnostics->warnings().front(),
        "constant/d:3: \"base\" is given twice, first in constant/d:1; what is added here comes too late for the macro in constant/d:2");
    EXPECT_EQ(Parsed("unit 1;\n#include \"none\"\na 1;\n").diagnostics->warnings(), Words{});
}

// Values may go on over several lines wherever OpenFOAM's own writers and tutorials do so.
TEST(DictionarySyntax, valuesMayGoOnOverLines)
{
    const Parsed p(R"(
div(phi,U)      Gauss
                linearUpwind grad(U);
internalField
    uniform (0 0 0);
type
    fixedValue;
div(phi,Y)
    Gauss multivariateSelection
    {
        Y   limitedLinear 1;
    };
libs
(
    "a.so"
    "b.so"
)
;
list
(
    (1 2 3)
    (4 5 6)
);
field nonuniform List<scalar>
2
(
1
2
);
sub
{
    nu
        [0 2 -1 0 0 0 0]
        1e-6;
}
)");
    EXPECT_EQ(p.errors(), "");
    EXPECT_EQ(p.dict.keys().size(), 8u);
    EXPECT_EQ(p.dict.get<Words>("libs"), (Words{"a.so", "b.so"}));
    EXPECT_EQ(p.dict.get<Numbers>("field"), (Numbers{1, 2}));
    EXPECT_EQ(p.dict.get<std::string>("type"), "fixedValue");
    EXPECT_EQ(p.dict.subDict("sub").get("nu", units::kinematicViscosity), 1e-6);
    EXPECT_EQ(p.errors(), "");
}
