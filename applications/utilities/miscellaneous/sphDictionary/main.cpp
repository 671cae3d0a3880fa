/// Shows and edits entries of dictionaries from scripts, on machines without OpenFOAM's foamDictionary.
#include "CommandLine.hpp"
#include "DictionaryText.hpp"
#include <CLI/CLI.hpp>
#include <fmt/format.h>

int main(int argc, char** argv)
{
    std::string file, entry, newValue;
    bool valueOnly = false, listKeywords = false;
    CLI::Option* set = nullptr;

    const auto options = [&](CLI::App& app)
    {
        app.add_option("--entry", entry, "Entry to show or set, a.b for b in dictionary a; else the whole file")
            ->type_name("<a.b>");
        auto* value = app.add_flag("--value", valueOnly, "Show the value alone, without keyword and ';'");
        auto* keywords = app.add_flag("--keywords", listKeywords, "List the keywords of the file or of the entry");
        set = app.add_option("--set", newValue, "Give the entry this value, leaving the rest of the file as it is")
                  ->type_name("<value>");
        set->excludes(value)->excludes(keywords);
        app.add_option("file", file, "Dictionary, relative to the case folder")->required();
    };
    const auto body = [&](const std::filesystem::path& caseFolder)
    {
        if (set->count() > 0)
        {
            if (entry.empty()) throw sph::CaseError("-set needs an -entry to set");
            sph::setEntry(caseFolder, file, entry, newValue);
            return 0;
        }
        const auto diagnostics = std::make_shared<sph::Diagnostics>();
        const auto dictionary = sph::Dictionary::read(caseFolder, file, diagnostics);
        diagnostics->throwIfAny();
        if (listKeywords)
            for (const auto& keyword : sph::keywords(dictionary, entry)) fmt::print("{}\n", keyword);
        else if (valueOnly && !entry.empty())
            fmt::print("{}\n", sph::valueText(dictionary, entry));
        else
            fmt::print("{}", sph::entryText(dictionary, entry));
        return 0;
    };
    return sph::runApplication("sphDictionary", argc, argv,
                               "Shows or sets entries of a dictionary, with macros and includes resolved. Setting an entry keeps "
                               "comments, macros and includes of the file.",
                               options, body);
}
