#include "dictionary/addDefaults.hpp"
#include "dictionary/DictionaryNode.hpp"

namespace sph
{

namespace
{
void add(Dictionary::Node& to, const Dictionary::Node& defaults)
{
    for (auto entry : defaults.entries)
    {
        if (auto* own = to.find(entry.keyword); !own)
        {
            entry.ignored = entry.isDefault = true;
            to.entries.push_back(std::move(entry));
        }
        else if (own->dictionary && entry.dictionary) add(*own->dictionary, *entry.dictionary);
    }
}
}

bool isDefault(const Dictionary& dict, const std::string& key)
{
    const auto* entry = dict.node().find(key);
    return entry && entry->isDefault;
}

void addDefaults(const Dictionary& dict, const Dictionary& defaults) { add(dict.node(), defaults.node()); }

}
