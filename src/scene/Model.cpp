#include "scene/Model.hpp"
#include "dictionary/addDefaults.hpp"
#include "schemes/schemeSets.hpp"
#include <fmt/format.h>

namespace sph
{

bool Reading::paper() const { return settings.has(entry::scheme, "paper"); }

const std::string& Reading::choose(const Choice& entry, const std::string& fallback) const
{
    return settings.chosen[entry.keyword()] = entry(schemes, fallback);
}

void Reading::belongs(const Parameter& entry, const Parameter& to) const
{
    if (entry.given(schemes) && !to.given(schemes))
        entry.error(schemes, fmt::format("does nothing without {}; give that a value, or leave this out", to.keyword()));
}

void Reading::doesNothing(const Parameter& entry, const std::string& why) const
{
    if (entry.given(schemes) && !isDefault(schemes, entry.keyword()))
        entry.error(schemes, fmt::format("{} does nothing here: {}; leave it out", entry.keyword(), why));
}

}
