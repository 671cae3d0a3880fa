/// Variants of a case, as system/variantsDict and variants/ have them.
#include "sweeps/cloneCase.hpp"
#include "TestCase.hpp"
#include <gtest/gtest.h>

namespace sph::test
{
namespace
{

const Files files{{"system/controlDict", "endTime 1;\nfunctions { errors { type errors; } }\n"},
                  {"system/sphSchemes", "resolution { spacing 0.1; }\n"},
                  {"constant/geometry", "walls\n{\n    left { type plane; }   // goes with `open`\n    right { type plane; }\n}\n"},
                  {"constant/walls", "written by meshToGhost\n"},
                  {"0/lagrangian/sph/U", "packed\n"},
                  {"variants/oil/constant/phaseProperties", "phases (oil);\n"},
                  {"variants/oil/system/sphSchemes", "resolution { spacing 0.3; support 2; }\n"},
                  {"system/variantsDict", "fine { \"system/sphSchemes\" { resolution { spacing #eval \"0.1/2\"; } } }\n"
                                          "open { \"constant/geometry\" { walls { ~left; } } }\n"
                                          "long { $fine; \"system/controlDict\" { endTime 9; } }\n"
                                          "oil-open { \"system/controlDict\" { endTime 3; } \"constant/phaseProperties\" { rho 1; } }\n"
                                          "as-it-is { }\n"}};

template<class T> T entryOf(const TestCase& c, const std::string& run, const std::string& file, const std::vector<std::string>& keys)
{
    auto d = Dictionary::read(c.folder() / "run" / run, file, std::make_shared<Diagnostics>());
    for (std::size_t k = 0; k + 1 < keys.size(); ++k) d = d.subDict(keys[k]);
    return d.get<T>(keys.back());
}
double spacing(const TestCase& c, const std::string& run)
{
    return entryOf<double>(c, run, "system/sphSchemes", {"resolution", "spacing"});
}
double endTime(const TestCase& c, const std::string& run) { return entryOf<double>(c, run, "system/controlDict", {"endTime"}); }

std::string refusal(const TestCase& c, const std::string& name)
{
    try
    {
        cloneCase(c.folder(), name);
    }
    catch (const CaseError& e)
    {
        return e.what();
    }
    return "";
}

TEST(CloneCase, ChangesEntries)
{
    const TestCase c(files);
    EXPECT_EQ(cloneCase(c.folder(), "fine"), "run/fine");
    EXPECT_EQ(spacing(c, "fine"), 0.05);
    EXPECT_EQ(endTime(c, "fine"), 1);
    cloneCase(c.folder(), "long");
    EXPECT_EQ(spacing(c, "long"), 0.05);
    EXPECT_EQ(endTime(c, "long"), 9);
    cloneCase(c.folder(), "as-it-is");
    EXPECT_EQ(c.read("run/as-it-is/system/sphSchemes"), c.read("system/sphSchemes"));
}

// The rest of the line goes with the entry, and every other line stays.
TEST(CloneCase, RemovesEntries)
{
    const TestCase c(files);
    cloneCase(c.folder(), "open");
    EXPECT_EQ(c.read("run/open/constant/geometry"), "walls\n{\n       // goes with `open`\n    right { type plane; }\n}\n");
}

// A name of several: folders first, then entries from left to right; one that the dictionary has whole counts alone.
TEST(CloneCase, PutsVariantsTogether)
{
    const TestCase c(files);
    cloneCase(c.folder(), "oil-fine");
    EXPECT_EQ(spacing(c, "oil-fine"), 0.05);
    EXPECT_EQ(entryOf<double>(c, "oil-fine", "system/sphSchemes", {"resolution", "support"}), 2);
    EXPECT_EQ(c.read("run/oil-fine/constant/phaseProperties"), "phases (oil);\n");
    cloneCase(c.folder(), "oil-open"); // of whose files one comes with the folder
    EXPECT_EQ(c.read("run/oil-open/constant/phaseProperties"), "phases (oil);\nrho             1;\n");
    EXPECT_EQ(endTime(c, "oil-open"), 3);
    EXPECT_EQ(spacing(c, "oil-open"), 0.3);
    EXPECT_EQ(c.read("run/oil-open/constant/geometry"), c.read("constant/geometry"));
}

// What an include brings is changed by lines behind it, and the file that is included stays.
TEST(CloneCase, ChangesWhatIsIncluded)
{
    auto all = files;
    all["constant/geometry"] = "#include \"tank\"\n";
    all["constant/tank"] = "dimension 2;\nwalls { left { type plane; slip no; } }\n";
    all["system/variantsDict"] = "smooth { \"constant/geometry\" { dimension 3; walls { left { slip yes; } right { type box; } } } }\n";
    const TestCase c(all);
    cloneCase(c.folder(), "smooth");
    EXPECT_EQ(entryOf<int>(c, "smooth", "constant/geometry", {"dimension"}), 3);
    EXPECT_TRUE(entryOf<bool>(c, "smooth", "constant/geometry", {"walls", "left", "slip"}));
    EXPECT_EQ(entryOf<std::string>(c, "smooth", "constant/geometry", {"walls", "left", "type"}), "plane");
    EXPECT_EQ(entryOf<std::string>(c, "smooth", "constant/geometry", {"walls", "right", "type"}), "box");
    EXPECT_EQ(c.read("run/smooth/constant/tank"), c.read("constant/tank"));
}

// What programs have written in the case does not come along; what they have written in the copy stays when it is renewed.
TEST(CloneCase, LeavesWhatProgramsWrite)
{
    const TestCase c(files);
    cloneCase(c.folder(), "fine");
    EXPECT_FALSE(std::filesystem::exists(c.folder() / "run/fine/constant/walls"));
    EXPECT_FALSE(std::filesystem::exists(c.folder() / "run/fine/0"));
    c.write("run/fine/log.sphFoamLike", "Time = 1\n");
    c.write("run/fine/constant/walls", "its own\n");
    c.write("run/fine/system/sphSchemes", "resolution { spacing 7; }\n");
    cloneCase(c.folder(), "fine");
    EXPECT_EQ(spacing(c, "fine"), 0.05);
    EXPECT_EQ(c.read("run/fine/log.sphFoamLike"), "Time = 1\n");
    EXPECT_EQ(c.read("run/fine/constant/walls"), "its own\n");
}

TEST(CloneCase, RefusesWhatIsWrong)
{
    const TestCase c(files);
    EXPECT_EQ(
        refusal(c, "fien"),
        "system/variantsDict: there is no variant \"fien\". Did you mean \"fine\"? Known variants: as-it-is, fine, long, oil, oil-open, open.");
    EXPECT_EQ(
        refusal(c, "oil-fien"),
        "system/variantsDict: there is no variant \"fien\". Did you mean \"fine\"? Known variants: as-it-is, fine, long, oil, oil-open, open.");
    EXPECT_EQ(refusal(c, "../fine"), "variant \"../fine\" needs a name of letters, digits and _-+.");
    const auto message = [&](const std::string& entries)
    {
        c.write("system/variantsDict", "wrong { " + entries + " }\n");
        return refusal(c, "wrong");
    };
    EXPECT_EQ(
        message("\"system/sphScheme\" { spacing 1; }"),
        "system/variantsDict:1: the case has no file \"system/sphScheme\". Did you mean \"system/sphSchemes\"? Known files: constant/geometry, system/controlDict, system/sphSchemes, system/variantsDict.");
    EXPECT_EQ(
        message("\"constant/geometry\" { walls { ~top; } }"),
        "system/variantsDict:1: \"walls.top\" of constant/geometry cannot be removed: constant/geometry:1: there is no entry \"walls.top\". Known entries: left, right.");
    EXPECT_EQ(message("\"constant/geometry\" { walls { ~left yes; } }"),
              "system/variantsDict:1: \"walls.left\" goes: it can have no value here");
    EXPECT_EQ(message("\"system/controlDict\" { endTime; }"),
              "system/variantsDict:1: \"endTime\" needs a value, or ~ ahead of it where it is to go");
    EXPECT_FALSE(c.has("run/wrong")) << "what looks like the variant would be run as it";
    EXPECT_EQ(refusal(c, "wrong-"), "system/variantsDict: \"wrong-\" names no variant behind its last -");
    c.write("system/variantsDict", "other 3;\n");
    EXPECT_EQ(refusal(c, "other"),
              "system/variantsDict:1: is no variant: a variant is a dictionary of files, { \"system/controlDict\" { .. } }");
}

}
}
