#pragma once
#include "Dictionary.hpp"
#include <algorithm>
#include <optional>

namespace sph
{

/// As Dictionary::choose, but nothing where the word is missing or unknown. choose would go on with the first valid word, and
/// ask for the entries of a model that nobody chose; here the other entries of the dictionary are left in peace.
inline std::optional<std::string> knownWord(const Dictionary& dictionary, const std::string& key,
                                            std::span<const std::string> valid)
{
    const auto word = dictionary.found(key) ? dictionary.get<std::string>(key) : std::string();
    if (std::ranges::find(valid, word) != valid.end()) return word;
    dictionary.choose(key, valid);
    for (const auto& other : dictionary.keys()) dictionary.ignore(other);
    return {};
}

}
