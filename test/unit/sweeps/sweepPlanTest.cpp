/// workPrecisionDict as a plan, and what its overrides do to a copy of a case.
#include "TestCase.hpp"
#include "dictionary/DictionaryText.hpp"
#include "sweeps/CaseCopy.hpp"
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

const Files sweepFiles{{"system/controlDict", "endTime 1; // seconds\n"},
                       {"system/sphSchemes", "n 10;\nresolution\n{\n    spacing #eval \"1.0/$n\";\n    support 2.6; // spacings\n}\n"},
                       {"constant/geometry", "dimension 2;\n"},
                       {"constant/walls", "old\n"},
                       {"0/lagrangian/sph/U", "start\n"}};

const std::string dictionary = "resolutions (16 8);\n"
                               "setResolution { \"system/sphSchemes\" { n $n; } }\n"
                               "variants\n{\n    plain { }\n"
                               "    fast { \"system/sphSchemes\" { integration { scheme leapfrog; damping { rate #eval \"2*$n\"; "
                               "} } resolution { support 3; } } }\n}\n"
                               "errors ( { field U; } { field p; norm Linf; time 0.5; } );\n";

TestCase caseWith(const std::string& text)
{
    auto all = sweepFiles;
    all["system/workPrecisionDict"] = text;
    return TestCase(all);
}

std::string mistakesOfPlan(const std::string& text)
{
    const auto folder = caseWith(text);
    const Case c(folder.folder());
    readSweepPlan(c);
    try
    {
        c.diagnostics().throwIfAny();
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
    return "";
}

// What a case includes from outside is included by its copies, wherever they lie; what is its own is the copy's own.
TEST(CaseCopy, KeepsIncludes)
{
    const TestCase c({{"base/common", "a 1;\n"},
                      {"case/constant/own", "b 2;\n"},
                      {"case/system/workPrecisionDict", ""},
                      {"case/constant/phaseProperties", "#include \"../../base/common\"\n#include \"own\" // here\nc 3;\n"}});
    const auto copy = c.folder() / "case/run/workPrecision/plain/8";
    copyInputs(c.folder() / "case", copy, false);
    c.write("case/run/workPrecision/plain/8/constant/own", "b 20;\n");
    const auto dict = Dictionary::read(copy, "constant/phaseProperties", std::make_shared<Diagnostics>());
    EXPECT_EQ(dict.get<double>("a"), 1);
    EXPECT_EQ(dict.get<double>("b"), 20);
    EXPECT_EQ(dict.get<double>("c"), 3);
    dict.diagnostics().throwIfAny();
}

// Coarse first, all variants of a resolution together; $n is the resolution everywhere in the dictionary.
TEST(SweepPlan, IsReadForEachResolution)
{
    const auto folder = caseWith(dictionary);
    const Case c(folder.folder());
    const auto plan = readSweepPlan(c);
    EXPECT_NO_THROW(c.diagnostics().throwIfAny());
    ASSERT_EQ(plan.runs.size(), 4u);
    EXPECT_EQ(plan.runs[0].name(), "plain/8");
    EXPECT_EQ(plan.runs[1].name(), "fast/8");
    EXPECT_EQ(plan.runs[3].name(), "fast/16");
    EXPECT_EQ(plan.runs[0].overrides.size(), 1u);
    const auto& overrides = plan.runs[3].overrides;
    ASSERT_EQ(overrides.size(), 4u);
    EXPECT_EQ(overrides[0].value, "16");
    EXPECT_EQ(overrides[2].entry(), "integration.damping.rate");
    EXPECT_EQ(overrides[2].value, "32");
    EXPECT_EQ(toString(overrides[2].where), "system/workPrecisionDict:6");
    ASSERT_EQ(plan.errors.size(), 2u);
    EXPECT_EQ(plan.errors[0].norm, "L2");
    EXPECT_FALSE(plan.errors[0].time);
    EXPECT_EQ(plan.errors[1].time, 0.5);
    EXPECT_EQ(plan.repeats, 1);
    EXPECT_FALSE(plan.timeLimit);
}

// The copy's entries have their values, those made of them by macros follow, comments stay, missing dictionaries are added; what
// meshToGhost wrote is not copied, and the start only where no step makes one.
TEST(CaseCopy, HasTheOverrides)
{
    const auto folder = caseWith(dictionary);
    const Case c(folder.folder());
    const auto plan = readSweepPlan(c);
    const auto to = folder.folder() / "run/workPrecision/fast/16";
    copyInputs(plan.baseCase, to, false);
    apply(plan.runs[3].overrides, to, c.diagnostics());
    EXPECT_NO_THROW(c.diagnostics().throwIfAny());
    const auto schemes = Dictionary::read(to, "system/sphSchemes", c.sharedDiagnostics());
    EXPECT_EQ(valueText(schemes, "resolution.spacing"), "0.0625");
    EXPECT_EQ(valueText(schemes, "resolution.support"), "3");
    EXPECT_EQ(valueText(schemes, "integration.scheme"), "leapfrog");
    EXPECT_EQ(valueText(schemes, "integration.damping.rate"), "32");
    EXPECT_NE(contentsOf(to / "system/sphSchemes").find("// spacings"), std::string::npos);
    EXPECT_EQ(placeOf(plan.runs[3].overrides[3], to).line, 5);
    EXPECT_FALSE(std::filesystem::exists(to / "constant/walls"));
    EXPECT_FALSE(std::filesystem::exists(to / "0"));
    copyInputs(plan.baseCase, to, true);
    EXPECT_TRUE(std::filesystem::exists(to / "0/lagrangian/sph/U"));
    EXPECT_EQ(folder.read("system/sphSchemes"), sweepFiles.at("system/sphSchemes"));
}

// The stamp of inputs changes with a byte, with a name, and with what is said beside them; not with the folder.
TEST(CaseCopy, HasAStampOfItsInputs)
{
    const TestCase a(sweepFiles), b(sweepFiles);
    const auto stamp = inputsStamp(a.folder(), {}, {"x"});
    EXPECT_EQ(stamp.size(), 16u);
    EXPECT_EQ(stamp, inputsStamp(b.folder(), {}, {"x"}));
    EXPECT_NE(stamp, inputsStamp(b.folder(), {}, {"y"}));
    b.replace("system/controlDict", "endTime 1", "endTime 2");
    EXPECT_EQ(inputsStamp(a.folder(), {"system/controlDict"}, {}), inputsStamp(b.folder(), {"system/controlDict"}, {}));
    EXPECT_NE(stamp, inputsStamp(b.folder(), {}, {"x"}));
    b.replace("system/controlDict", "endTime 2", "endTime 1");
    std::filesystem::rename(b.folder() / "constant/walls", b.folder() / "constant/wall");
    EXPECT_NE(stamp, inputsStamp(b.folder(), {}, {"x"}));
}

// The coarsest resolutions and the named variants are left, in the plan's order.
TEST(SweepPlan, ASelectionLeavesItsRuns)
{
    const auto folder = caseWith(dictionary);
    const auto left = [&](const SweepSelection& selection)
    {
        auto plan = readSweepPlan(Case(folder.folder()));
        select(plan, selection);
        std::string names;
        for (const auto& run : plan.runs) names += run.name() + " ";
        return names;
    };
    EXPECT_EQ(left({}), "plain/8 fast/8 plain/16 fast/16 ");
    EXPECT_EQ(left({{"fast"}, 0}), "fast/8 fast/16 ");
    EXPECT_EQ(left({{"fast", "plain"}, 1}), "plain/8 fast/8 ");
    EXPECT_EQ(left({{}, 7}), "plain/8 fast/8 plain/16 fast/16 ");
    EXPECT_THROW(left({{"fats"}, 1}), CaseError);
}

TEST(SweepPlan, NamesMistakes)
{
    const std::string rest = "setResolution { }\nerrors ( { field U; } );\n";
    const auto all = mistakesOfPlan(
        "resolutions (8 0 -4 8);\nsetResolution { \"system/sphScheme\" { a 1; } }\nvariants { \"a/b\" { } c { system 1; } }\n"
        "errors ( { norm L3; } );\nrepeats 0;\ntimeLimit -1;\nresolution 1;\n");
    for (const char* what :
         {"Dict:1: resolution 0 must be greater than 0", "Dict:1: resolution -4 must be", "Dict:1: resolution 8 stands twice",
          "Dict:2: the case has no file \"system/sphScheme\". Did you mean \"system/sphSchemes\"?",
          "Dict:3: variant \"a/b\" needs a name of letters", "Dict:3: \"system\" must be a file of the case", "L3", "\"field\" is missing",
          "Dict:5: \"repeats\" must be at least 1", "Dict:6:", "Dict:7: entry \"resolution\" is not used here"})
        EXPECT_NE(all.find(what), std::string::npos) << what << " not in\n" << all;

    EXPECT_NE(mistakesOfPlan("resolutions ();\n" + rest).find("\"resolutions\" is empty"), std::string::npos);
    EXPECT_NE(mistakesOfPlan(rest).find("entry \"resolutions\" is missing"), std::string::npos);
    EXPECT_NE(mistakesOfPlan("n 3;\nresolutions (1);\n" + rest).find("Dict:1: \"n\" is given from outside"), std::string::npos);
    EXPECT_NE(mistakesOfPlan("resolutions (1 2);\nerrors ( { field U; } );\n").find("\"setResolution\" is missing"), std::string::npos);
    const std::string ladder = "resolutions (1);\nsetResolution { }\n";
    EXPECT_NE(mistakesOfPlan(ladder + "errors ( { field U; norm mean; } );\n").find("Dict:3: norm mean is one over time"),
              std::string::npos);
    EXPECT_NE(mistakesOfPlan(ladder + "errors ( { field U; norm rms; } );\n").find("Dict:3: norm rms is one over time"), std::string::npos);
    EXPECT_NE(mistakesOfPlan(ladder + "errors ( { field U; norm mean; averageFrom 2; time 1; } );\n").find("averageFrom 2 is after time 1"),
              std::string::npos);
    EXPECT_NE(mistakesOfPlan(ladder + "errors ( { field U; averageFrom 2; } );\n").find("entry \"averageFrom\" is not used here"),
              std::string::npos);
    EXPECT_NE(mistakesOfPlan("baseCase nowhere;\nresolutions (1);\n" + rest).find("Dict:1: there is no case folder \"nowhere\""),
              std::string::npos);
}

}
}
