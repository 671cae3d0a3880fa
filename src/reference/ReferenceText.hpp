/// The reference of entries, and of the columns of tables, as text: for the terminal, for a page, and as a file to fill in.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{

/// Part of the reference that a path names, as `system/controlDict.functions.errors`: a file, a sub-dictionary, the entries of a word of a choice, one
/// entry, or with `postProcessing/errors` the table that it writes. Freely named dictionaries (walls, functions) may be left out of the path.
struct ReferencePart
{
    std::string path, meaning;
    std::vector<ListedEntry> entries;
    std::vector<Column> columns; ///< of a table, which has no entries
};
/// The path by which `findPart` finds the table of a writer: "postProcessing/errors".
std::string pathOf(const TableInfo&);
/// "`errors.dat`: errors against .."
std::string meaningOf(const TableInfo&);
/// Throws CaseError with what was meant and what is possible.
ReferencePart findPart(const EntryRegistry&, const std::string& path);

/// Every entry with type, unit, default, choices and meaning, those of sub-dictionaries indented; every column with unit and meaning.
std::string listText(const ReferencePart&);
/// The reference as tables in Markdown.
std::string markdownText(const ReferencePart&);
/// A dictionary that can be read, and of a table an error: what is required with a value, all else commented out.
std::string templateText(const ReferencePart&);
/// Keywords and words that may follow the path, for completion.
std::vector<std::string> wordsBelow(const ReferencePart&);

}
