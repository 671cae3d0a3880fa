#include "meshes/readers/RegionNames.hpp"
#include <algorithm>
#include <fmt/format.h>

namespace sph
{

namespace
{

/// A word that a dictionary can have for a keyword.
std::string validWord(std::string_view name)
{
    std::string word(name);
    for (char& c : word)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_' && c != '-') c = '_';
    if (!std::isalpha(static_cast<unsigned char>(word.front()))) word.insert(0, "_");
    return word;
}

}

int RegionNames::index(std::string_view name)
{
    if (const auto there = known_.find(name); there != known_.end()) return there->second;
    const int index = int(words_.size());
    auto word = name.empty() ? fmt::format("patch{}", index) : validWord(name);
    const auto same = word;
    for (int n = 2; std::find(words_.begin(), words_.end(), word) != words_.end(); ++n) word = fmt::format("{}_{}", same, n);
    if (!name.empty() && word != name) notes_.push_back(fmt::format("region \"{}\" is called {}", name, word));
    known_.emplace(name, index);
    words_.push_back(word);
    return index;
}

}
