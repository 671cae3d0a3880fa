/// Dictionaries as text: showing them, and editing one entry of a file in place.
#pragma once
#include "dictionary/Dictionary.hpp"

namespace sph
{

/// An entry by its path, "functions.probes.interval" (or with '/' or ':' between the keywords): its value alone, macros
/// expanded and without ';', or "{ .. }" of a dictionary. Throws CaseError where it is missing.
std::string valueText(const Dictionary&, const std::string& path);

/// Text of an entry with its keyword, as a dictionary file has it; an empty path gives the whole dictionary.
std::string entryText(const Dictionary&, const std::string& path);

/// The keywords of the dictionary at `path` in the order of the file, patterns in quotes.
std::vector<std::string> keywords(const Dictionary&, const std::string& path);

/// Gives one entry of `caseFolder/file` another value and leaves every other character of the file as it is: comments, macros and
/// includes stay. A missing entry is added at the end of its dictionary, which must exist. Throws CaseError where the file or the
/// value has mistakes, or where the entry's text stands in an included file or in the dictionary that a macro takes over.
void setEntry(const std::filesystem::path& caseFolder, const std::string& file, const std::string& path, const std::string& value);

/// Adds an entry at the end of the file, on top of those of its keyword that are there: dictionaries merge. Throws CaseError where the file or the value has mistakes.
void appendEntry(const std::filesystem::path& caseFolder, const std::string& file, const std::string& keyword, const std::string& value);

/// Takes one entry out of `caseFolder/file`, with the rest of its line where nothing else stands there; every other character stays. Throws CaseError as setEntry
/// does, and where there is no such entry.
void removeEntry(const std::filesystem::path& caseFolder, const std::string& file, const std::string& path);

}
