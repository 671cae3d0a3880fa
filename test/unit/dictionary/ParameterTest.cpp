/// What is declared is what is read: defaults, ranges, units and words of an entry, and the mistakes that are told.
#include "Parsed.hpp"
#include "dictionary/EntryList.hpp"

using namespace sph;

namespace
{
const Scalar factor{"factor", units::none, 0.4, positive, "a share"}, width{"width", units::m, required, positive, "a width"},
    theta{"theta", units::none, 0.5, between(0.5, 1), "the implicit share"}, level{"level", units::m, byScene("the floor"), "a level"};
const Count steps{"steps", 3, atLeast(1), "a number"};
const Choice density{"density", {"numberDensity", {"continuity", "is integrated"}}, "numberDensity", "where it comes from"};
const Direction normal{"normal", Vector<3>{0, 1, 0}, "out of the wall"};
const Switch closed{"closed", false, "is it closed"};
const Text title{"title", "", "above the picture"};
const ListOf<double> sizes{"sizes", std::vector<double>{1, 2}, "some sizes"};
const Choices formats{"formats", "formats", {"vtp", "stl"}, std::vector<std::string>{"vtp"}, "what is written"};
const SubDictionary box{"box", notGiven, "a box"};
const PairValues sigma{"sigma", "surface tension", units::surfaceTension, nonNegative, "surface tension of two phases"};
const AutomaticScalar sound{"sound", units::mPerS, byScene("10 x the largest velocity"), positive, "speed of sound"};
}

// The declared defaults are read where nothing is given; a default of the scene's where the declaration leaves it to the reader.
TEST(Parameters, defaults)
{
    const Parsed p("");
    EXPECT_EQ(factor(p.dict), 0.4);
    EXPECT_EQ(factor(p.dict, 0.2), 0.2);
    EXPECT_EQ(level(p.dict, 7), 7);
    EXPECT_EQ(steps(p.dict), 3);
    EXPECT_EQ(density(p.dict), "numberDensity");
    EXPECT_EQ(normal(p.dict), (Vector<3>{0, 1, 0}));
    EXPECT_FALSE(closed(p.dict));
    EXPECT_EQ(title(p.dict), "");
    EXPECT_EQ(sizes(p.dict).size(), 2u);
    EXPECT_EQ(formats(p.dict).size(), 1u);
    EXPECT_TRUE(sigma(p.dict).empty());
    EXPECT_FALSE(sound(p.dict));
    EXPECT_FALSE(width.given(p.dict));
    EXPECT_FALSE(width.ifGiven(p.dict));
    EXPECT_EQ(p.errors(), "");
}

TEST(Parameters, given)
{
    const Parsed p("factor 2; width [m] 3; level 1; steps 5; density continuity; normal (0 0 2); closed yes; title \"a b\"; sizes (3); "
                   "formats (stl vtp); sound automatic; sigma ((a b) 2);");
    EXPECT_EQ(factor(p.dict), 2);
    EXPECT_EQ(width(p.dict), 3);
    EXPECT_EQ(level(p.dict, 7), 1);
    EXPECT_EQ(steps(p.dict), 5);
    EXPECT_EQ(density(p.dict), "continuity");
    EXPECT_EQ(density.index(p.dict), 1);
    EXPECT_EQ(normal(p.dict), (Vector<3>{0, 0, 1}));
    EXPECT_EQ(normal.asGiven(p.dict), (Vector<3>{0, 0, 2}));
    EXPECT_TRUE(closed(p.dict));
    EXPECT_EQ(title(p.dict), "a b");
    EXPECT_EQ(sizes(p.dict).size(), 1u);
    EXPECT_EQ(formats(p.dict).size(), 2u);
    EXPECT_EQ(sigma(p.dict).size(), 1u);
    EXPECT_FALSE(sound(p.dict));
    p.dict.reportUnused();
    EXPECT_EQ(p.errors(), "");
}

// One message for each mistake, and a value that is possible.
TEST(Parameters, mistakes)
{
    const auto read = [](const auto& parameter, const std::string& text)
    {
        const Parsed p(text);
        parameter(p.dict);
        return p.errors();
    };
    EXPECT_EQ(read(width, ""), "constant/d: entry \"width\" is missing");
    EXPECT_EQ(read(width, "width 0;"), "constant/d:1: \"width\" must be positive, found 0");
    EXPECT_EQ(read(width, "width [s] 1;"), "constant/d:1: \"width\" has dimensions [0 0 1 0 0 0 0], expected [0 1 0 0 0 0 0]");
    EXPECT_EQ(read(width, "width wide;"), "constant/d:1: \"width\" must be a number, found \"wide\"");
    EXPECT_EQ(read(theta, "theta 0.2;"), "constant/d:1: \"theta\" must be 0.5 to 1, found 0.2");
    EXPECT_EQ(read(steps, "steps 0;"), "constant/d:1: \"steps\" must be at least 1, found 0");
    EXPECT_EQ(read(steps, "steps 1.5;"), "constant/d:1: \"steps\" must be an integer, found \"1.5\"");
    EXPECT_EQ(read(normal, "normal (0 0 0);"), "constant/d:1: normal must have a direction, not (0 0 0)");
    EXPECT_EQ(read(density, "density continuty;"),
              "constant/d:1: density \"continuty\" is unknown. Did you mean \"continuity\"? Known density: numberDensity, continuity.");
    EXPECT_EQ(read(formats, "formats (stll);"), "constant/d:1: \"stll\" is unknown. Did you mean \"stl\"? Known formats: vtp, stl.");
    EXPECT_EQ(read(Scalar{"a", units::none, required, atLeast(2).saying("a is a pair at least"), ""}, "a 1;"),
              "constant/d:1: a is a pair at least");
    const Parsed p("width -1; theta 7;");
    EXPECT_EQ(width(p.dict), 1);
    EXPECT_EQ(theta(p.dict), 0.5);
}

// The entries of an unknown word are unknown too: one message, and none for the rest.
TEST(Parameters, unknownWordLeavesTheRestInPeace)
{
    const Parsed p("density none; factr 3;");
    EXPECT_FALSE(density.known(p.dict));
    p.dict.reportUnused();
    EXPECT_EQ(p.errors(), "constant/d:1: density \"none\" is unknown. Known density: numberDensity, continuity.");
}

TEST(Parameters, information)
{
    EXPECT_EQ(factor.info().fallback, "0.4");
    EXPECT_EQ(factor.info().range, "> 0");
    EXPECT_EQ(theta.info().range, "0.5 to 1");
    EXPECT_TRUE(width.info().isRequired);
    EXPECT_EQ(width.info().unit, "m");
    EXPECT_EQ(level.info().fallback, "the floor");
    EXPECT_FALSE(level.info().isFixed);
    EXPECT_EQ(density.info().choices[1].meaning, "is integrated");
    EXPECT_EQ(Scalar("a", units::kg * units::m / units::s / units::s, 1, "").info().unit, "kg m s^-2");
}

// Two models add to one file: their entries stand beside one another, sub-dictionaries and choices are merged.
TEST(Parameters, listsOfOneFileAreMerged)
{
    EntryRegistry registry;
    registry.add("system/s", {factor, {box, {theta}}, {density, {{"continuity", {steps}}}}}, "a file");
    registry.add("system/s", {width, {box, {level}}, {density, {{"continuity", {normal}}}}});
    const auto& list = registry.find("system/s")->entries;
    ASSERT_EQ(list.size(), 4u);
    EXPECT_EQ(list[1].inside.size(), 2u);
    EXPECT_EQ(list[2].cases.size(), 1u);
    EXPECT_EQ(list[2].cases[0].second.size(), 2u);
    EXPECT_EQ(registry.find("system/t"), nullptr);
}
