#include "Model.hpp"
#include <fmt/format.h>

namespace sph
{

const std::string& Reading::choose(const std::string& entry, const std::vector<std::string>& words, const std::string& fallback) const
{
    const auto preferred = settings.preferred.find(entry);
    return settings.chosen[entry] = schemes.choose(entry, words, preferred == settings.preferred.end() ? fallback : preferred->second);
}

void Reading::belongs(const char* entry, const char* to) const
{
    if (schemes.found(entry) && !schemes.found(to))
        schemes.error(entry, fmt::format("does nothing without {}; give that a value, or leave this out", to));
}

}
