/// Sets of words for system/sphSchemes, one for each class of scenes: `scheme freeSurface;` stands for what the tutorials of that class have been measured to
/// want. Words that the file gives itself override; a set's support is that of its kernel, and goes with no other.
#pragma once
#include "dictionary/EntryList.hpp"

namespace sph
{

namespace entry
{
extern const Choice scheme;
}

/// Adds the words of the set that `scheme` names. Every program that reads system/sphSchemes begins with it (readResolution).
void addSchemeSet(const Dictionary& sphSchemes);
/// Adds the words of another set.
void addSchemeSet(const Dictionary& sphSchemes, const std::string& set);
/// Whether the file gives a word of a set itself, but for `integration`: somebody has chosen.
bool givesWordsOf(const std::string& set, const Dictionary& sphSchemes);
/// The words of a set, as they would stand in the file.
std::string wordsOfSet(const std::string& set);

EntryList schemeEntries();

}
