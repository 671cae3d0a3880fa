#include "dictionary/EntryList.hpp"
#include <algorithm>

namespace sph
{

namespace
{
using Entries = std::vector<ListedEntry>;

/// Adds what is not there yet; sub-dictionaries and the cases of a choice are merged.
void merge(Entries& into, const Entries& more)
{
    for (const auto& entry : more)
    {
        const auto same = std::ranges::find(into, entry.info.keyword, [](const ListedEntry& e) { return e.info.keyword; });
        if (same == into.end())
        {
            into.push_back(entry);
            continue;
        }
        merge(same->inside, entry.inside);
        for (const auto& choice : entry.info.choices)
            if (std::ranges::find(same->info.choices, choice.word, &ChoiceWord::word) == same->info.choices.end())
                same->info.choices.push_back(choice);
        for (const auto& [word, entries] : entry.cases)
            if (const auto found = std::ranges::find(same->cases, word, [](const auto& c) { return c.first; }); found != same->cases.end())
                merge(found->second, entries);
            else same->cases.push_back({word, entries});
    }
}
}

ListedEntry::ListedEntry(const Parameter& p, const EntryList& holds) : info(p.info()), inside(holds) {}

ListedEntry::ListedEntry(const Choice& choice, const Cases& byWord) : info(choice.info())
{
    for (const auto& [word, entries] : byWord)
        if (!entries.empty()) cases.push_back({word.word, entries});
}

Cases operator+(Cases a, const Cases& b)
{
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

ChoiceWords wordsOf(const Cases& cases)
{
    ChoiceWords words;
    for (const auto& [word, entries] : cases) words.push_back(word);
    return words;
}

EntryList& EntryList::operator+=(const EntryList& more)
{
    merge(*this, more);
    return *this;
}

void EntryRegistry::add(const std::string& file, const EntryList& entries, const std::string& meaning)
{
    auto found = std::ranges::find(files_, file, &File::name);
    if (found == files_.end()) found = files_.insert(files_.end(), {file, meaning, {}});
    found->entries += entries;
}

const EntryRegistry::File* EntryRegistry::find(const std::string& file) const
{
    const auto found = std::ranges::find(files_, file, &File::name);
    return found == files_.end() ? nullptr : &*found;
}

}
