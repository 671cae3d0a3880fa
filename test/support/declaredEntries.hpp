/// Compares what the readers of a dictionary look up with what is declared of it (EntryList.hpp): dictionaries are written that have
/// every declared entry, and such that have the required ones, once with each word of each choice that brings entries of its own. What
/// their values mean does not matter.
#pragma once
#include "dictionary/DictionaryNode.hpp"
#include "dictionary/EntryList.hpp"
#include <algorithm>
#include <functional>
#include <set>

namespace sph::test
{

using Entries = std::vector<ListedEntry>;

/// A name in place of freely chosen ones, of walls, phases, fields ...
inline const std::string freeName = "someName";

inline std::string exampleOf(const ParameterInfo& i)
{
    if (i.type == "word" || i.type == "text") return freeName;
    if (i.type == "list of words") return "(" + (i.choices.empty() ? freeName : i.choices.front().word) + ")";
    if (i.type == "list of numbers" || i.type == "list of whole numbers") return "(1 2)";
    if (i.type == "list of vectors") return "((0 0 0) (3 0 0))";
    if (i.type == "list of lists of numbers") return "((0 0 0 1))";
    if (i.type == "number or automatic") return "1";
    return i.example;
}

inline int variantsOf(const Entries& entries)
{
    int most = 1;
    for (const auto& e : entries)
    {
        most = std::max(most, variantsOf(e.inside));
        int words = 0;
        for (const auto& choice : e.info.choices)
        {
            const auto found = std::ranges::find(e.cases, choice.word, [](const auto& c) { return c.first; });
            words += found == e.cases.end() ? 1 : variantsOf(found->second);
        }
        most = std::max(most, words);
    }
    return most;
}

inline std::string variantOf(const Entries& entries, int variant, bool whole)
{
    std::string text;
    for (const auto& e : entries)
    {
        const auto& i = e.info;
        const auto keyword = i.keyword.starts_with('<') ? freeName : i.keyword;
        if (i.type == "list of dictionaries")
        {
            if (!e.inside.empty()) text += keyword + " ( { " + variantOf(e.inside, variant % variantsOf(e.inside), whole) + "} );\n";
        }
        else if (!e.inside.empty() || i.type == "dictionary")
            text += keyword + " { " + (e.inside.empty() ? "" : variantOf(e.inside, variant % variantsOf(e.inside), whole)) + "}\n";
        else if (!whole && !i.isRequired && e.cases.empty()) continue;
        else if (i.type != "choice") text += keyword + " " + exampleOf(i) + ";\n";
        else
        {
            int k = variant % variantsOf({e});
            for (const auto& choice : i.choices)
            {
                const auto found = std::ranges::find(e.cases, choice.word, [](const auto& c) { return c.first; });
                const int count = found == e.cases.end() ? 1 : variantsOf(found->second);
                if (k >= 0 && k < count)
                {
                    text += keyword + " " + choice.word + ";\n";
                    if (found != e.cases.end()) text += variantOf(found->second, k, whole);
                }
                k -= count;
            }
        }
    }
    return text;
}

/// Keywords that stand in the dictionary of these entries, whatever its words, and the dictionaries below.
inline void collect(const Entries& entries, const std::string& path, std::set<std::string>& keywords)
{
    for (const auto& e : entries)
    {
        const auto own = path + "." + (e.info.keyword.starts_with('<') ? freeName : e.info.keyword);
        keywords.insert(own);
        for (const auto& [word, beside] : e.cases) collect(beside, path, keywords);
        collect(e.inside, own, keywords);
    }
}

/// Empty where the two agree. `read` is called with the text of each variant; `apart`: declared of other programs, "file.keyword".
inline std::string difference(const std::string& file, const EntryList& declared, const std::function<void(const std::string& text)>& read,
                              const std::set<std::string>& apart = {})
{
    std::vector<std::pair<std::string, std::string>> lookUps;
    for (int k = 0; k < variantsOf(declared); ++k)
    {
        for (const bool whole : {true, false})
        {
            lookUpLog = &lookUps;
            try
            {
                read(variantOf(declared, k, whole));
            }
            catch (const CaseError&)
            {}
            lookUpLog = nullptr;
        }
    }
    std::set<std::string> known, found;
    collect(declared, file, known);
    std::string differences;
    for (auto [dictionary, keyword] : lookUps)
    {
        if (dictionary != file && !dictionary.starts_with(file + ".")) continue;
        // elements of lists of dictionaries are called by their number
        std::string path = file;
        for (std::size_t at = file.size(); at < dictionary.size();)
        {
            const auto end = std::min(dictionary.find('.', at + 1), dictionary.size());
            if (const auto word = dictionary.substr(at + 1, end - at - 1); word.find_first_not_of("0123456789") != std::string::npos)
                path += "." + word;
            at = end;
        }
        found.insert(path + "." + keyword);
    }
    for (const auto& key : found)
        if (!known.contains(key)) differences += key + " is read and not declared\n";
    for (const auto& key : known)
        if (!found.contains(key) && !apart.contains(key)) differences += key + " is declared and not read\n";
    return differences;
}

}
