#include "scene/Facts.hpp"
#include "base/CaseError.hpp"
#include <fmt/format.h>
#include <stdexcept>

namespace sph
{

void Facts::note(const std::type_info& fact, const char* says, const std::string& by)
{
    const auto [place, isNew] = given_.try_emplace(fact);
    auto& given = place->second;
    if (given.value.has_value()) throw CaseError(fmt::format("both {} and {} say {}: take one of them away", given.by, by, says));
    if (!isNew) throw std::logic_error(fmt::format("somebody asked {} before {} said so", says, by));
    given.by = by;
}

}
