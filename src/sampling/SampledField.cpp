#include "SampledField.hpp"
#include "words.hpp"
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

const std::vector<std::string>& componentNames(FieldClass type)
{
    static const std::vector<std::string> scalar{""}, vector{"x", "y", "z"}, tensor{"xx", "xy", "xz", "yy", "yz", "zz"};
    return type == FieldClass::vector ? vector : type == FieldClass::symmTensor ? tensor : scalar;
}

std::vector<std::string> columnNames(const SampledField& field)
{
    std::vector<std::string> names;
    for (const auto& c : componentNames(field.type())) names.push_back(c.empty() ? field.name() : field.name() + "_" + c);
    return names;
}

}
