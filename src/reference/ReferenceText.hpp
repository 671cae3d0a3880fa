/// The reference of entries as text: for the terminal, for a page, and as a file to fill in.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{

/// Part of the reference that a path names, as `system/controlDict.functions.errors`: a file, a sub-dictionary, the entries of a word of a choice, or one
/// entry. Freely named dictionaries (walls, functions) may be left out of the path.
struct ReferencePart
{
    std::string path, meaning;
    std::vector<ListedEntry> entries;
};
/// Throws CaseError with what was meant and what is possible.
ReferencePart findPart(const EntryRegistry&, const std::string& path);

/// Every entry with type, unit, default, choices and meaning; those of sub-dictionaries indented.
std::string listText(const ReferencePart&);
/// The reference as tables in Markdown.
std::string markdownText(const ReferencePart&);
/// A dictionary that can be read: what is required with a value, all else commented out.
std::string templateText(const ReferencePart&);
/// Keywords and words that may follow the path, for completion.
std::vector<std::string> wordsBelow(const ReferencePart&);

}
