#include "sampling/SampledField.hpp"
#include "base/words.hpp"
#include <fmt/format.h>

namespace sph
{

SampledField::SampledField(const ParticleView& view, const std::string& name, const Location& where)
{
    if (const auto* found = view.find(name))
    {
        field_ = *found;
        return;
    }
    std::vector<std::string> known;
    for (const auto& f : view.fields) known.push_back(f.name);
    throw CaseError(where, fmt::format("field \"{}\" is unknown. {}", name, suggestion(name, "fields", known)));
}

std::vector<std::string> columnNames(const SampledField& field)
{
    std::vector<std::string> names;
    for (const auto c : componentNames(field.type())) names.push_back(c.empty() ? field.name() : fmt::format("{}_{}", field.name(), c));
    return names;
}

}
