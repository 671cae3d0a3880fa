/// The reference names what there is, in words and as a file that can be read.
#include "reference/ReferenceText.hpp"
#include "dictionary/DictionaryText.hpp"
#include "messages.hpp"
#include "reference/reference.hpp"
#include <gtest/gtest.h>
#include <regex>

using namespace sph;

namespace
{

Dictionary parsed(const std::string& text, const std::shared_ptr<Diagnostics>& diagnostics)
{
    const auto dict = Dictionary::parse(text, "system/d", diagnostics);
    diagnostics->throwIfAny();
    return dict;
}

/// The text with the entries that are commented out; explanations begin with //- or follow an entry.
std::string withoutComments(const std::string& text) { return std::regex_replace(text, std::regex("(^|\n)( *)// "), "$1$2"); }

/// Every entry whose default is a value has that value in the file, down to sub-dictionaries of given names.
void expectDefaults(const Dictionary& dict, const std::vector<ListedEntry>& entries, const std::string& path)
{
    for (const auto& e : entries)
    {
        const auto own = path + e.info.keyword;
        if (e.info.isFixed) { EXPECT_EQ(valueText(dict, own), e.info.fallback) << own; }
        if (e.info.type == "dictionary" && own[0] != '<') expectDefaults(dict, e.inside, own + ".");
    }
}

}

// Templates can be read as they are, and with all that is commented out; then the defaults are there.
TEST(Reference, templatesCanBeRead)
{
    for (const auto& file : reference().files())
    {
        const auto text = templateText(findPart(reference(), file.name));
        EXPECT_NO_THROW(parsed(text, std::make_shared<Diagnostics>())) << text;
        const auto open = withoutComments(text);
        auto all = Dictionary::empty("", std::make_shared<Diagnostics>());
        EXPECT_NO_THROW(all = parsed(open, std::make_shared<Diagnostics>())) << open;
        expectDefaults(all, file.entries, "");
    }
}

TEST(Reference, partsByPath)
{
    const auto keywords = [](const std::string& path)
    {
        std::vector<std::string> all;
        for (const auto& e : findPart(reference(), path).entries) all.push_back(e.info.keyword);
        return all;
    };
    using Words = std::vector<std::string>;
    EXPECT_EQ(keywords("constant/geometry.walls.sphere"), (Words{"centre", "radius", "fluid", "omega", "origin"}));
    EXPECT_EQ(keywords("constant/geometry.domain.periodic"), Words{"periodic"});
    EXPECT_EQ(keywords("system/controlDict.functions.errors.reference.couette"),
              (Words{"nu", "width", "velocity", "normal", "origin", "steady"}));
    EXPECT_EQ(keywords("system/sphSchemes.resolution"), (Words{"spacing", "support", "kernel"}));
    EXPECT_THROW(findPart(reference(), "system/nothing"), CaseError);
    try
    {
        findPart(reference(), "system/sphSchemes.resolution.spacin");
        FAIL();
    }
    catch (const CaseError& e)
    {
        EXPECT_STREQ(
            e.what(),
            "system/sphSchemes.resolution has no entry \"spacin\". Did you mean \"spacing\"? Known entries: kernel, spacing, support.");
    }
}

// The tables that are written stand beside the files that are read; nothing of them is to be filled in.
TEST(Reference, knowsTheColumnsOfTables)
{
    const auto part = findPart(reference(), "postProcessing/bedHydrodynamics");
    const auto text = listText(part);
    for (const auto* says : {"postProcessing/bedHydrodynamics: `bedHydrodynamics.dat`: ", "superficial_<phase>      m/s\n",
                             "volume of the liquid over that of the pores"})
        EXPECT_PRED2(sph::says, text, says);
    EXPECT_PRED2(says, markdownText(findPart(reference(), "postProcessing/errors")), "| `executionTime` | s | processor time");
    EXPECT_PRED2(says, messageOf([&] { templateText(part); }), "postProcessing/bedHydrodynamics is written by the suite");
    EXPECT_PRED2(says, messageOf([] { findPart(reference(), "postProcessing/erors"); }), "Did you mean \"postProcessing/errors\"?");
    for (const auto& table : reference().tables())
        for (const auto& column : table.columns) EXPECT_NE(column.meaning, "") << table.writer << " " << column.name;
}

// Each entry is told whole: type, unit, range, default, choices with their meaning, meaning.
TEST(Reference, listsSayAll)
{
    const auto text = listText(findPart(reference(), "system/packParticlesDict"));
    for (const auto* part :
         {"number [spacings], 0 to 0.5; default 0\n", "largest displacement of each component", "nearest to the walls", "choice; required"})
        EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
    const auto page = markdownText(findPart(reference(), "constant/geometry"));
    for (const auto* part : {"| `dimension` | whole number 2 to 3 |  | **required** | of space |", "## `constant/geometry.walls`\n",
                             "## `constant/geometry.walls.<wall>`, type `cone`\n"})
        EXPECT_NE(page.find(part), std::string::npos) << part << "\n" << page;
}
