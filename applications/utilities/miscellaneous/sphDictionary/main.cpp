/// Shows and edits entries of dictionaries from scripts, on machines without OpenFOAM's foamDictionary, and says which entries there are.
#include "base/CommandLine.hpp"
#include "dictionary/DictionaryText.hpp"
#include "reference/ReferenceText.hpp"
#include "reference/reference.hpp"
#include <fmt/format.h>

namespace
{

struct Options
{
    std::string file, entry, newValue, listed, asTemplate;
    bool valueOnly = false, keywords = false, markdown = false;
    sph::CommandLine::Option set, list, makeTemplate;
};

void print(const std::vector<std::string>& lines)
{
    for (const auto& line : lines) fmt::print("{}\n", line);
}

void list(const Options& o)
{
    if (o.listed.empty())
    {
        for (const auto& file : sph::reference().files()) fmt::print("{:<32} {}\n", file.name, o.keywords ? "" : file.meaning);
        for (const auto& table : sph::reference().tables())
            fmt::print("{:<32} {}\n", sph::pathOf(table), o.keywords ? "" : sph::meaningOf(table));
        return;
    }
    const auto part = sph::findPart(sph::reference(), o.listed);
    if (o.keywords) print(sph::wordsBelow(part));
    else fmt::print("{}", o.markdown ? sph::markdownText(part) : sph::listText(part));
}

void show(const Options& o, const std::filesystem::path& caseFolder)
{
    const auto diagnostics = std::make_shared<sph::Diagnostics>();
    const auto dictionary = sph::Dictionary::read(caseFolder, o.file, diagnostics);
    diagnostics->throwIfAny();
    if (o.keywords) print(sph::keywords(dictionary, o.entry));
    else if (o.valueOnly && !o.entry.empty()) fmt::print("{}\n", sph::valueText(dictionary, o.entry));
    else fmt::print("{}", sph::entryText(dictionary, o.entry));
}

}

int main(int argc, char** argv)
{
    Options o;
    const auto options = [&](sph::CommandLine& line)
    {
        line.option("entry", o.entry, "a.b", "Entry to show or set, a.b for b in dictionary a; else the whole file");
        const auto value = line.flag("value", o.valueOnly, "Show the value alone, without keyword and ';'");
        const auto keywords = line.flag("keywords", o.keywords, "List the keywords of the file or of the entry");
        o.set = line.option("set", o.newValue, "value", "Give the entry this value, leaving the rest of the file as it is");
        o.list = line.option("list", o.listed, "file.a.b",
                             "Say which entries a file may have: system/controlDict.functions.errors; which columns a table has: "
                             "postProcessing/errors; without a file: which files")
                     .valueOptional();
        const auto markdown = line.flag("markdown", o.markdown, "List as a page in Markdown").needs(o.list);
        o.makeTemplate = line.option("template", o.asTemplate, "dictionary", "Print a file to fill in, with every entry that it may have");
        o.set.excludes(value).excludes(keywords).excludes(o.list).excludes(o.makeTemplate);
        o.makeTemplate.excludes(o.list).excludes(markdown);
        line.argument("file", o.file, "Dictionary, relative to the case folder");
    };
    const auto body = [&](const std::filesystem::path& caseFolder)
    {
        if (o.list.given()) list(o);
        else if (o.makeTemplate.given()) fmt::print("{}", sph::templateText(sph::findPart(sph::reference(), o.asTemplate)));
        else if (o.file.empty()) throw sph::CaseError("file is required. See 'sphDictionary -help' for usage");
        else if (!o.set.given()) show(o, caseFolder);
        else if (o.entry.empty()) throw sph::CaseError("-set needs an -entry to set");
        else sph::setEntry(caseFolder, o.file, o.entry, o.newValue);
        return 0;
    };
    return sph::runApplication("sphDictionary", argc, argv,
                               "Shows or sets entries of a dictionary, with macros and includes resolved. Setting an entry keeps "
                               "comments, macros and includes of the file. With -list and -template it says which entries there are.",
                               options, body, sph::Banner::none);
}
